"""The tools that make packages: the tag of the wheel, the list of contents (SPDX), the citation."""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path
from unittest import mock

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

    def test_files_of_the_checkout_are_refused(self):
        data = b"\0/home/a/talweg/build/sources/b.c\0./src/c.cpp\0/home/a/talweg-2/d.c\0x=/home/a/talweg/e.c\0"
        self.assertEqual(wheel_tag.files_named(data, Path("/home/a/talweg")),
                         ["names /home/a/talweg/build/sources/b.c", "names /home/a/talweg/e.c"])
        self.assertEqual(wheel_tag.files_named(data, Path("/src")), [])

    def test_a_program_for_this_machine_only_is_refused(self):
        with self.assertRaisesRegex(SystemExit, "needs libstdc"):
            wheel_tag.tag([Path(os.environ["TALWEG_DRIVER"])])


class Spdx(unittest.TestCase):
    FILES = ("talweg-1.2.3-py3-none-manylinux_2_29_x86_64.whl", "talweg-1.2.3-linux-x86_64.tar.gz",
             "talweg_1.2.3-1_amd64.deb", "talweg-page-1.2.3.zip", "talweg-1.2.3.tar.gz",
             "talweg-openflipper-1.2.3.tar.gz", "python3-talweg_1.2.3-1_all.deb")
    NPM = "talweg-npm-1.2.3.tgz"
    WINDOWS = ("talweg-1.2.3-windows-x86_64.zip", "talweg-1.2.3-py3-none-win_amd64.whl",
               "talweg_blender-1.2.3-windows.zip")

    def setUp(self):
        # Packages that are not installed on every machine that runs tests.
        for function, made_up in (("debian_version", lambda package: "1:2.0+b1"),
                                  ("unpacked_version", lambda package, root: "1:2.0+b1")):
            version_of = mock.patch.object(spdx, function, made_up)
            version_of.start()
            self.addCleanup(version_of.stop)
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        folder = Path(temporary.name)
        names = (*self.FILES, *self.WINDOWS, self.NPM)
        for name in names:
            (folder / name).write_bytes(b"abc")
        self.document = spdx.document("1.2.3", 0, "/", [folder / name for name in names])
        self.names = {part["SPDXID"]: part["name"] for part in self.document["packages"]}
        self.files = {entry["fileName"][2:]: entry for entry in self.document["files"]}

    def related(self, name, how):
        own = self.files[name]["SPDXID"]
        return {self.names[relation["relatedSpdxElement"]] for relation in self.document["relationships"]
                if relation["spdxElementId"] == own and relation["relationshipType"] == how}

    def test_document(self):
        self.assertEqual(self.document["creationInfo"]["created"], "1970-01-01T00:00:00Z")
        ids = [*(part["SPDXID"] for part in self.document["packages"]),
               *(entry["SPDXID"] for entry in self.document["files"]), "SPDXRef-DOCUMENT"]
        self.assertEqual(len(ids), len(set(ids)))
        for relation in self.document["relationships"]:
            self.assertIn(relation["spdxElementId"], ids)
            self.assertIn(relation["relatedSpdxElement"], ids)

    def test_sums_of_both_kinds(self):
        # The checksums of "abc" in FIPS 180-2. SPDX 2.3 requires the first one and allows the second.
        self.assertEqual({one["algorithm"]: one["checksumValue"] for one in self.document["files"][0]["checksums"]},
                         {"SHA1": "a9993e364706816aba3e25717850c26c9cd0d89d",
                          "SHA256": "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"})

    def test_each_file_has_its_own_parts(self):
        wheel, archive, deb, page, *sources = self.FILES
        self.assertIn("unwinder of libgcc", self.related(wheel, "CONTAINS"))
        self.assertEqual(self.related(archive, "CONTAINS") - self.related(wheel, "CONTAINS"),
                         {"CLI11", "xxHash", "libpng"})
        self.assertLess({"three.js", "three-mesh-bvh", "fast_float"}, self.related(page, "CONTAINS"))
        self.assertEqual(self.related(page, "CONTAINS") - self.related(self.NPM, "CONTAINS"),
                         {"three.js", "three-mesh-bvh", "meshoptimizer"})
        self.assertNotIn("fmt", self.related(deb, "CONTAINS"))
        self.assertEqual(self.related(deb, "DYNAMIC_LINK"), {"CHOLMOD with its supernodal module"})
        self.assertEqual(self.files[deb]["licenseConcluded"],
                         "MIT AND BSD-3-Clause AND MPL-2.0 AND BSD-2-Clause")
        self.assertIn(" AND LGPL-2.1-or-later", self.files[wheel]["licenseConcluded"])
        self.assertIn("(Apache-2.0 OR MIT)", self.files[page]["licenseConcluded"])
        for name in sources:
            self.assertEqual(self.related(name, "CONTAINS"), set())
            self.assertEqual(self.files[name]["licenseConcluded"], "MIT")

    def test_files_for_windows_have_all_inside(self):
        archive, wheel, addon = self.WINDOWS
        inside = self.related(wheel, "CONTAINS")
        self.assertLess({"zlib", "pugixml", "fmt", "mingw-w64's C runtime"}, inside)
        self.assertNotIn("unwinder of libgcc", inside)
        self.assertEqual(self.related(addon, "CONTAINS"), inside)
        self.assertEqual(self.related(archive, "CONTAINS") - inside, {"CLI11", "xxHash", "libpng"})
        self.assertIn(" AND LGPL-2.1-or-later", self.files[wheel]["licenseConcluded"])

    def test_versions(self):
        versions = {part["name"]: part["versionInfo"] for part in self.document["packages"]}
        lock = json.loads((PROJECT / "plugins/hosts/browser/package.json").read_text())
        self.assertEqual(versions["three.js"], lock["dependencies"]["three"])
        self.assertRegex(versions["CHOLMOD (Core, Check, Cholesky), AMD, COLAMD of SuiteSparse"], r"^5\.\d+\.\d$")
        for part in self.document["packages"]:
            if part["name"] == "Eigen":
                self.assertEqual(part["externalRefs"][0]["referenceLocator"],
                                 "pkg:deb/debian/libeigen3-dev@1%3A2.0%2Bb1")

    def test_all_that_the_page_depends_on_is_listed(self):
        page = json.loads((PROJECT / "plugins/hosts/browser/package.json").read_text())
        self.assertEqual(set(page["dependencies"]), set(spdx.NPM))

    def test_licences_of_all_parts_for_any_linux_are_beside_them(self):
        script = (PROJECT / "plugins/packages/portable/build.sh").read_text()
        for key in (*spdx.PLUGINS, *spdx.PROGRAM, "libpng-dev"):
            self.assertIn(key, script)


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


class Workflows(unittest.TestCase):
    def test_workflows_call_existing_commands(self):
        commands = re.findall(r"(?m)^([a-z]+)\)", (PROJECT / "run").read_text())
        made = (PROJECT / "plugins/packages/release.sh").read_text()
        for workflow in (PROJECT / ".github/workflows").glob("*.yml"):
            text = workflow.read_text()
            self.assertTrue(re.search(r"(?m)^on:$", text) and re.search(r"(?m)^jobs:$", text))
            for command in re.findall(r"\./run ([a-z]+)", text):
                self.assertIn(command, commands)
            for script in re.findall(r"run: (?:>\s+)?((?:\.ci|plugins|tests)/\S+)", text):
                self.assertTrue(os.access(PROJECT / script, os.X_OK), script)
            for file in re.findall(r"build/release/out/([A-Z]\S+)", text):
                self.assertIn(f"$out/{file}", made)


class Versions(unittest.TestCase):
    def test_everything_has_the_same(self):
        citation = (PROJECT / "CITATION.cff").read_text()
        self.assertIn(f"\nversion: {version()}\n", citation)
        for key in ("cff-version", "message", "title", "authors", "preferred-citation"):
            self.assertRegex(citation, rf"(?m)^{key}:")
        self.assertTrue(re.search(r"(?m)^## (\S+)", (PROJECT / "CHANGELOG.md").read_text())[1] == version())
        for file, name in (("plugins/hosts/python/talweg/_version.py", "__version__ = \"{}\""),
                           ("plugins/hosts/openflipper/Plugin-Talweg/TalwegPlugin.hh", "QString(\"{}\")"),
                           ("README.md", "talweg-{}-linux-x86_64"), ("docs/packaging.md", "talweg-{}-linux-aarch64"),
                           ("docs/python.md", "talweg-{}-py3")):
            self.assertIn(name.format(version()), (PROJECT / file).read_text(), file)

    def test_only_the_tag_of_this_version_is_released(self):
        check = PROJECT / "plugins/packages/check_tag.sh"
        subprocess.run([check, f"v{version()}"], check=True)
        refused = subprocess.run([check, "v99.0.0"], check=False, capture_output=True, text=True)
        self.assertEqual(refused.returncode, 1)
        self.assertIn(f"the tag is v99.0.0, but CMakeLists.txt has version {version()}", refused.stderr)


if __name__ == "__main__":
    unittest.main()
