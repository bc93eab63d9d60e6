"""What packages are made with: the wheel's tag, the list of what is inside, the citation."""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "plugins/packages"))
sys.dont_write_bytecode = True
import same_zip  # noqa: E402
import spdx  # noqa: E402
import wheel_tag  # noqa: E402


def version():
    return re.search(r"VERSION ([0-9.]+)", (PROJECT / "CMakeLists.txt").read_text().split("project")[1])[1]


class WheelTag(unittest.TestCase):
    def test_newest_symbol_counts(self):
        text = "0x0010: Name: GLIBC_2.4 Flags: none\n Name: GLIBC_2.31\n Name: GLIBC_2.9 GLIBCXX_3.4.30"
        self.assertEqual(wheel_tag.newest_glibc(text), (2, 31))
        self.assertEqual(wheel_tag.newest_glibc("Name: GLIBC_2.2.5"), (2, 2))

    def test_foreign_libraries_and_paths_are_refused(self):
        text = (" 0x01 (NEEDED)  Shared library: [libc.so.6]\n"
                " 0x01 (NEEDED)  Shared library: [libtalweg-cholmod.so.3]\n"
                " 0x01 (NEEDED)  Shared library: [libstdc++.so.6]\n"
                " 0x1d (RUNPATH) Library runpath: [$ORIGIN:$ORIGIN/../lib:/usr/local/lib]\n")
        self.assertEqual(wheel_tag.problems(text, {"libtalweg-cholmod.so.3"}),
                         ["needs libstdc++.so.6", "looks for libraries in \"/usr/local/lib\""])

    def test_a_program_for_this_machine_only_is_refused(self):
        with self.assertRaisesRegex(SystemExit, "needs libstdc"):
            wheel_tag.tag([Path(os.environ["TALWEG_DRIVER"])])


class Spdx(unittest.TestCase):
    def test_document(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "a.whl")
            file.write_bytes(b"abc")
            done = [subprocess.run([sys.executable, PROJECT / "plugins/packages/spdx.py", "1.2.3", "0",
                                    file], check=True, capture_output=True, text=True).stdout
                    for _ in range(2)]
        self.assertEqual(done[0], done[1])
        document = json.loads(done[0])
        self.assertEqual(document["creationInfo"]["created"], "1970-01-01T00:00:00Z")
        # sha256 of "abc", as in FIPS 180-2.
        self.assertEqual(document["files"][0]["checksums"][0]["checksumValue"],
                         "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad")
        ids = [part["SPDXID"] for part in document["packages"]]
        self.assertEqual(len(ids), len(set(ids)))
        for relation in document["relationships"]:
            self.assertIn(relation["relatedSpdxElement"], ids)


class Zip(unittest.TestCase):
    def test_same_bytes_whenever_it_was_written(self):
        with tempfile.TemporaryDirectory() as folder:
            packed = []
            for seconds in (1_000_000_000, 1_700_000_000):
                inside = Path(folder, "addon")
                inside.mkdir(exist_ok=True)
                (inside / "b.py").write_text("b")
                (inside / "a.py").write_text("a")
                os.utime(inside / "a.py", (seconds, seconds))
                same_zip.pack(inside, Path(folder, "z.zip"), 1_600_000_000)
                packed.append(Path(folder, "z.zip").read_bytes())
            self.assertEqual(packed[0], packed[1])
            with zipfile.ZipFile(Path(folder, "z.zip")) as archive:
                self.assertEqual(archive.namelist(), ["addon/a.py", "addon/b.py"])


class Versions(unittest.TestCase):
    def test_everything_has_the_same(self):
        citation = (PROJECT / "CITATION.cff").read_text()
        self.assertIn(f"\nversion: {version()}\n", citation)
        for key in ("cff-version", "message", "title", "authors", "preferred-citation"):
            self.assertRegex(citation, rf"(?m)^{key}:")
        self.assertTrue(re.search(r"(?m)^## (\S+)", (PROJECT / "CHANGELOG.md").read_text())[1] == version())


if __name__ == "__main__":
    unittest.main()
