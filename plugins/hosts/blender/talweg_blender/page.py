"""Opens the add-on's page, which the zip contains, in the browser."""

import html
import re
import tempfile
from pathlib import Path

import bpy

_FOLDER = Path(__file__).parent / "page"
_STYLE = ("body{font:16px/1.5 sans-serif;max-width:48em;margin:2em auto;padding:0 1em}img{max-width:100%}"
          "code,pre{background:#eee;padding:.1em .3em}pre{padding:1em;overflow:auto}"
          "td,th{padding:.2em .6em;text-align:left;vertical-align:top}")


def as_html(text, folder):
    """HTML of the Markdown that Talweg's pages use: headings, lists, tables, code, pictures, emphasis and
    links."""
    text = re.sub(r"<!--.*?-->\n?", "", text, flags=re.S)
    parts = re.split(r"^```\w*\n(.*?)^```\n", text, flags=re.S | re.M)
    out = []
    for number, part in enumerate(parts):
        if number % 2:
            out.append(f"<pre>{html.escape(part)}</pre>")
        else:
            out += [_block(block) for block in re.split(r"\n\s*\n", part.strip()) if block]
    base = f'<base href="{folder.as_uri()}/">'
    return f'<!doctype html><meta charset="utf-8">{base}<style>{_STYLE}</style>' + "\n".join(out)


def _block(block):
    heading = re.match(r"(#+) (.*)", block)
    if heading:
        size = len(heading[1])
        return f"<h{size}>{_inline(heading[2])}</h{size}>"
    for mark, tag in ((r"- ", "ul"), (r"\d+\. ", "ol")):
        if re.match(mark, block):
            items = re.split(rf"^{mark}", block, flags=re.M)[1:]
            return f"<{tag}>" + "".join(f"<li>{_inline(item)}</li>" for item in items) + f"</{tag}>"
    if block.startswith("|"):
        rows = [line.strip().strip("|").split("|") for line in block.splitlines() if "|--" not in line]
        return "<table>" + "".join("<tr>" + "".join(f"<td>{_inline(cell)}</td>" for cell in row) + "</tr>"
                                   for row in rows) + "</table>"
    return f"<p>{_inline(block)}</p>"


def _inline(text):
    text = html.escape(text.strip(), quote=False)
    text = re.sub(r"!\[([^\]]*)\]\(([^)]*)\)", r'<img src="\2" alt="\1">', text)
    # Links to pages outside the zip become plain text.
    text = re.sub(r"\[([^\]]*)\]\(https?:([^)]*)\)", r'<a href="https:\2">\1</a>', text)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"`([^`]*)`", r"<code>\1</code>", text)
    text = re.sub(r"\*\*([^*]+)\*\*", r"<b>\1</b>", text)
    return re.sub(r"\*([^*]+)\*", r"<i>\1</i>", text)


def written():
    """Writes the page as a temporary HTML file; returns its path."""
    text = (_FOLDER / "blender.md").read_text(encoding="utf-8")
    path = Path(bpy.app.tempdir or tempfile.gettempdir()) / "talweg.html"
    path.write_text(as_html(text, _FOLDER), encoding="utf-8")
    return path


class TALWEG_OT_page(bpy.types.Operator):
    """Open the add-on's page in the browser"""

    bl_idname = "talweg.page"
    bl_label = "How to Use Talweg"

    def execute(self, _context):
        bpy.ops.wm.url_open(url=written().as_uri())
        return {"FINISHED"}


def register():
    bpy.utils.register_class(TALWEG_OT_page)


def unregister():
    bpy.utils.unregister_class(TALWEG_OT_page)
