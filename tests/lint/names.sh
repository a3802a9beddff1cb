#!/usr/bin/env bash
# Everything comes from Debian through apt: no file names another package registry.
source "$(dirname "$0")/common.sh"

hosts='pypi[.]org|pythonhosted[.]org|npmjs[.](org|com)|yarnpkg[.]com|crates[.]io|rubygems[.]org'
hosts+='|docker[.]io|ghcr[.]io|quay[.]io|proxy[.]golang[.]org|conan[.]io|anaconda[.]org'
hosts+='|repo[0-9]*[.]maven|nuget[.]org|(deb|ftp|archive|security)[.](debian|ubuntu)[.](org|com)'
mapfile -t files < <(
    find . -path ./.git -prune -o -path ./build -prune -o -path ./out -prune -o -type f -print)
while read -r hit; do
    problem "$hit"
done < <(grep -InoE "$hosts" "${files[@]}")
finish "files" ${#files[@]}
