#!/bin/sh
# compilers.sh PROJECT BUILD FOLDER PLUGINS: a plugin and a host in C built by gcc and by clang: each
# host loads each plugin, and a host of either compiler runs the plugins of this build.
set -eu
project=$1 build=$2 folder=$3 plugins=$4
for compiler in gcc clang; do
  command -v $compiler >/dev/null || { echo "skipped: there is no $compiler"; exit 77; }
done
export TALWEG_PLUGIN_PATH
for pair in "gcc g++" "clang clang++"; do
  set -- $pair
  mkdir -p "$folder/$1"
  rm -f "$folder/$1"/*.o
  $1 -std=c11 -O1 -fPIC -fvisibility=hidden -shared -I"$build/include" \
    "$project/tests/plugins/toys/toy.c" -o "$folder/$1/toy.so"
  $2 -std=c++20 -O0 -fPIC -fvisibility=hidden -shared -I"$build/include" \
    "$project/docs/examples/height_plugin.cpp" -o "$folder/$1/height.so"
  for source in library_file module_check search_path shared_library system talweg_loader; do
    $2 -std=c++20 -O0 -c -I"$build/include" -DTALWEG_PLUGINS_FROM_PROGRAM='"none"' \
      -DTALWEG_INSTALLED_PLUGINS='"/none"' "$project/plugins/loader/$source.cpp" \
      -o "$folder/$1/$source.o"
  done
  $1 -std=c11 -O1 -c -I"$build/include" "$project/docs/examples/plugin_host.c" \
    -o "$folder/$1/host.o"
  $2 "$folder/$1"/*.o -ldl -o "$folder/$1/plugin_host"
  $1 -std=c11 -O1 -c -I"$build/include" "$project/tests/interface/list_plugins.c" \
    -o "$folder/$1/list_main.o"
  $2 "$folder/$1"/[lmst]*.o -ldl -o "$folder/$1/list_plugins"
  rm "$folder/$1/list_main.o"
done

printf 'v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\nf 1 3 4\nf 2 5 6\nf 2 6 3\n' \
  >"$folder/mesh.obj"
printf '0\n1\n5\n' >"$folder/curve.txt"
for host in gcc clang; do
  for plugin in gcc clang; do
    TALWEG_PLUGIN_PATH=$folder/$plugin
    "$folder/$host/list_plugins" >"$folder/list.txt"
    grep -q toy.count "$folder/list.txt"
    grep -q example.height "$folder/list.txt"
  done
  TALWEG_PLUGIN_PATH=$plugins
  "$folder/$host/plugin_host" "$folder/mesh.obj" "$folder/curve.txt" "$folder/$host.json" 1
done
cmp "$folder/gcc.json" "$folder/clang.json"
