// The points of the drawing: discs for clicks, squares for pins, dots for strokes, a ring around
// the point that closes the curve. Shapes repeat the meaning of colours.
import { BufferAttribute, BufferGeometry, Color, Points, ShaderMaterial } from 'three';
import type { Drawing, MeshInfo } from '../engine/types';
import { type Chosen, wasClicked } from '../state/state';
import type { Stage } from './stage';
import { positionOf } from './vectors';

const vertexShader = `
  attribute float size;
  attribute float shape;
  attribute vec3 fill;
  uniform float ratio;
  uniform float perPixel;  // size of a pixel at distance 1
  varying float vShape;
  varying vec3 vFill;
  varying float vSize;
  void main() {
    vec4 place = modelViewMatrix * vec4(position, 1.0);
    // Moved half a disc towards the eye, so that the mesh does not cut the disc.
    place.xyz += normalize(-place.xyz) * (-place.z) * perPixel * size * 0.6;
    gl_Position = projectionMatrix * place;
    gl_PointSize = size * ratio;
    vShape = shape;
    vFill = fill;
    vSize = size * ratio;
  }`;

const fragmentShader = `
  uniform vec3 rim;
  varying float vShape;
  varying vec3 vFill;
  varying float vSize;
  void main() {
    vec2 p = abs(gl_PointCoord * 2.0 - 1.0);
    float away = vShape > 0.5 ? max(p.x, p.y) * 1.12 : length(p);
    float soft = 2.0 / vSize;
    float cover = 1.0 - smoothstep(1.0 - soft, 1.0, away);
    if (cover <= 0.01) discard;
    float edge = smoothstep(1.0 - 4.0 * soft, 1.0 - 3.0 * soft, away);
    gl_FragColor = vec4(mix(vFill, rim, edge), cover);
    #include <colorspace_fragment>
  }`;

export class PointsView {
  private readonly material = new ShaderMaterial({
    vertexShader, fragmentShader, transparent: true,
    uniforms: { ratio: { value: 1 }, perPixel: { value: 1 }, rim: { value: new Color() } },
  });
  private readonly points = new Points(new BufferGeometry(), this.material);

  constructor(private readonly stage: Stage) {
    this.points.frustumCulled = false;
    this.points.renderOrder = 3;
    this.points.onBeforeRender = (renderer) => {
      this.material.uniforms.ratio.value = renderer.getPixelRatio();
      this.material.uniforms.perPixel.value = stage.camera.perPixel(1);
    };
    stage.onColours((colours) => this.material.uniforms.rim.value.set(colours.rim));
    stage.scene.add(this.points);
  }

  show(drawing: Drawing, mesh: MeshInfo | null, chosen: Chosen | null): void {
    this.points.geometry.dispose();
    const geometry = (this.points.geometry = new BufferGeometry());
    const places: number[] = [], sizes: number[] = [], shapes: number[] = [], fills: number[] = [];
    if (mesh) {
      drawing.curves.forEach((curve, c) => curve.points.forEach((point, k) => {
        const isFirst = drawing.unfinished && c === drawing.curves.length - 1 && k === 0;
        const isChosen = chosen?.curve === c && chosen.point === k;
        const look = this.look(point.pinned, wasClicked(point.exact), isFirst, isChosen);
        places.push(...positionOf(mesh, point));
        sizes.push(look.size);
        shapes.push(point.pinned ? 1 : 0);
        fills.push(...new Color(look.fill).toArray());
      }));
    }
    geometry.setAttribute('position', floats(places, 3));
    geometry.setAttribute('size', floats(sizes, 1));
    geometry.setAttribute('shape', floats(shapes, 1));
    geometry.setAttribute('fill', floats(fills, 3));
    this.stage.ask();
  }

  private look(pinned: boolean, clicked: boolean, isFirst: boolean, isChosen: boolean) {
    const colours = this.stage.colours;
    const size = isFirst ? 17 : clicked || pinned ? 12 : isChosen ? 10 : 5;
    if (isChosen) return { size: size + 4, fill: colours.chosen };
    if (pinned) return { size, fill: colours.pin };
    if (isFirst) return { size, fill: colours.first };
    return { size, fill: clicked ? colours.point : colours.drawn };
  }
}

function floats(values: number[], each: number): BufferAttribute {
  return new BufferAttribute(new Float32Array(values), each);
}
