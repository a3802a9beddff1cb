#!/usr/bin/env bash
# Each program's stages (files of one stem) compile and link by the reference compiler, without a GPU.
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
cd "$copies"
stages=(*.vert *.geom *.frag *.comp)
for stem in $(printf '%s\n' "${stages[@]%.*}" | sort -u); do
    glslangValidator -l "$stem".@(vert|geom|frag|comp) || problem "$folder/$stem: see above"
done
finish "stages" ${#stages[@]}
