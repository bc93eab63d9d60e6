#!/usr/bin/env python3
"""messages.py [FOLDER...]: prints all sentences for users as a Markdown list, by source file.

A sentence is a string literal of at least four words in the sources of the libraries, the driver and the
hosts; concatenated literals are joined, and {} stands for a value. Comments, docstrings and includes are left
out. A reader checks each sentence: it must say what happened, where, and what to do.
"""

import ast
import pathlib
import re
import subprocess
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("intrinsic", "heat", "core", "plugins/interface", "plugins/loader", "plugins/methods",
           "plugins/editing", "plugins/driver", "plugins/hosts")
COMMENT_OR_STRING = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"(?P<d>\w*)\((?P<raw>.*?)\)(?P=d)"|"(?P<text>(?:[^"\\\n]|\\.)*)"|"""
    r"""(?P<tick>`(?:[^`\\]|\\.)*`)|'(?:[^'\\\n]|\\.)+'""", re.DOTALL)
JOINED = re.compile(r"\s*\+?\s*")
ADDED = re.compile(r"\s*\+[^;,\"{}?]{1,120}?\+\s*")


def of_c(source):
    """(line, text) of the string literals of C++ or TypeScript; adjacent literals are joined."""
    found, end = [], -1
    for match in COMMENT_OR_STRING.finditer(source):
        text = match["raw"] or match["text"] or (match["tick"] or "")[1:-1]
        if match[0][0] == "'" and len(match[0]) > 4:  # TypeScript's quotes
            text = match[0][1:-1]
        if not text:
            continue
        if end >= 0 and JOINED.fullmatch(source, end, match.start()):
            found[-1][1] += text
        elif end >= 0 and ADDED.fullmatch(source, end, match.start()):
            found[-1][1] += "{}" + text
        else:
            found.append([source.count("\n", 0, match.start()) + 1, text])
        end = match.end()
    return found


def of_python(source):
    tree = ast.parse(source)
    docstrings = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            docstrings.add(id(node.value))
    inner = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in node.values}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            parts = [p.value if isinstance(p, ast.Constant) else "{}" for p in node.values]
            yield node.lineno, "".join(map(str, parts))
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) \
                and id(node) not in docstrings | inner:
            yield node.lineno, node.value


def sentences(path):
    source = path.read_text(encoding="utf-8")
    literals = of_python(source) if path.suffix == ".py" else of_c(source)
    for line, text in sorted(map(tuple, literals)):
        plain = " ".join(text.replace("\\n", " ").replace('\\"', '"').split())
        if len(re.findall(r"[A-Za-z]{2,}", plain)) >= 4 and " " in plain:
            yield line, plain


def main(folders):
    for folder in folders:
        listed = subprocess.run(["git", "ls-files", "-z", folder], cwd=PROJECT, check=True, capture_output=True)
        for path in sorted(PROJECT / name for name in listed.stdout.decode().split("\0") if name):
            if path.suffix not in {".cpp", ".hpp", ".h", ".cc", ".cxx", ".hh", ".py", ".ts"}:
                continue
            found = list(sentences(path))
            if found:
                print(f"\n## {path.relative_to(PROJECT)}\n")
                for line, text in found:
                    print(f"- {line}: {text}")


if __name__ == "__main__":
    main(sys.argv[1:] or FOLDERS)
