// Numbers as texts for the user.

/** Four significant digits, without zeros at the end. */
export function numberText(value: number): string {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(3);
  return String(Number(value.toPrecision(4)));
}

export function lengthText(value: number, unit: string): string {
  return unit ? `${numberText(value)} ${unit}` : numberText(value);
}

/** An angle in radians, written in degrees; less than a thousandth of a degree is 0. */
export function angleText(value: number): string {
  const degrees = (value * 180) / Math.PI;
  return `${numberText(Math.abs(degrees) < 1e-3 ? 0 : degrees)}°`;
}

export function countText(value: number): string {
  return value.toLocaleString('en');
}
