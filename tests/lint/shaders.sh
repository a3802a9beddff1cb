#!/usr/bin/env bash
# Each program's stages (files of one stem), in each variant, compile and link by the reference
# compiler, without a GPU.
# Our loader expands `#include "x.glsl"` itself; here copies ask the compiler to do it.
source "$(dirname "$0")/common.sh"
need glslangValidator

folder=gpu/shaders
copies=$(mktemp -d)
trap 'rm -rf "$copies"' EXIT
shopt -s nullglob extglob

for file in "$folder"/*; do
    awk '{ print } /^#version/ { print "#extension GL_GOOGLE_include_directive : require\n#line " NR + 1 }' \
        "$file" >"$copies/${file##*/}"
done

# variants STEM: the defines of each variant, one a line; an empty line where none are listed.
variants() {
    awk -v stem="$1" '$1 == stem { $1 = ""; print; listed = 1 } END { if (!listed) print "" }' \
        "$list"
}
list=$PWD/tests/lint/shaders.variants
cd "$copies"
stages=(*.vert *.geom *.frag *.comp)
count=0
for stem in $(printf '%s\n' "${stages[@]%.*}" | sort -u); do
    while read -ra defines; do
        count=$((count + 1))
        glslangValidator -l "${defines[@]}" "$stem".@(vert|geom|frag|comp) ||
            problem "$folder/$stem ${defines[*]}: see above"
    done < <(variants "$stem")
done
finish "programs" $count
