#!/bin/sh
# pip_from_source.sh OUT FOLDER: installs the source distribution that ./run release made (OUT) by pip in a
# new environment in FOLDER, without a network, with packages of Debian. The installed files are those of the
# wheel, and the first example of docs/python.md runs. Compiles the library. Not part of CI.
set -eu
out=$(cd "$1" && pwd)
page=$(cd "$(dirname "$0")/../../docs" && pwd)/python.md
rm -rf "$2"
/usr/bin/python3 -m venv --system-site-packages "$2"
folder=$(cd "$2" && pwd)
file=$(echo "$out"/talweg-[0-9]*.[0-9].tar.gz)
export PYTHONDONTWRITEBYTECODE=1 LC_ALL=C
unset PYTHONPATH TALWEG_PLUGIN_PATH 2>/dev/null || true
start=$(date +%s)
"$folder/bin/pip" install -q --no-build-isolation --no-index "$file"
echo "pip install from source: $(($(date +%s) - start)) s, $(du -sm "$folder" | cut -f1) MiB"

cd "$folder"
here=$(bin/python -c "import talweg; print(talweg.__path__[0])")
case $here in "$folder"/*) ;; *) echo "$here is not the one that was installed" >&2; exit 1 ;; esac
(cd "$here/.." && find talweg -name __pycache__ -prune -o -type f -print) | sort >installed
# A wheel for any Linux brings a library and licences beside the plugins.
/usr/bin/python3 -m zipfile -l "$(echo "$out"/*_x86_64.whl)" | awk '$1 ~ /^talweg\// { print $1 }' |
  grep -v -e '^talweg/plugins/libtalweg-' -e '^talweg/plugins/licences/' | sort >wheel
diff installed wheel
awk '/^## The first/ { here = 1 } here && /^```$/ { exit } code; here && /^```python/ { code = 1 }' \
  "$page" >example.py
bin/python example.py
bin/pip uninstall -q -y talweg
test ! -e "$here"
