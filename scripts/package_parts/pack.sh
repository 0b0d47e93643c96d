# SPDX-License-Identifier: BSD-3-Clause
# Building, staging and packing. Sourced by scripts/package.

if [[ -n $(distribution) ]]; then
  name=ros-$(distribution)-safety-control-cloud prefix=/opt/ros/$(distribution)
else
  name=safety-control-cloud prefix=/usr
fi
build=$root/build/package
stage=$build/stage

# In a folder of its own: below /usr, Debian's catkin puts libraries into the architecture's folder.
build_for_packing() {
  if [[ -e $build/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
    rm -rf "$build"  # a clone that was moved: a build holds absolute paths
  fi
  export PATH=/usr/bin:$PATH
  configure build/package -DCMAKE_BUILD_TYPE=Release -DCATKIN_ENABLE_TESTING=OFF -DCATKIN_BUILD_BINARY_PACKAGE=ON \
    -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_CXX_FLAGS="-ffile-prefix-map=$root/="
  compile build/package all
}

# All that is packed, as it will lie below /. Without what Python compiled: each machine's makes its own.
stage() {
  rm -rf "$stage"
  quietly "installing into build/package/stage/" \
    env DESTDIR="$stage" cmake --install build/package --strip
  find "$stage" -name __pycache__ -prune -exec rm -r {} +
  find "$stage" -type d -empty -delete  # the pictures in it are left out
  if [[ $prefix == /usr ]]; then place_nodelet; fi
  local documents=$stage/usr/share/doc/$name
  mkdir -p "$documents"
  cp LICENSE "$documents/copyright"
  gzip -9n <CHANGELOG.rst >"$documents/changelog.gz"
}

# In Debian nobody sets CMAKE_PREFIX_PATH, and its pluginlib looks beside the libraries; Debian 11's looks there alone.
place_nodelet() {
  local library
  library=$(find "$stage/usr/lib" -name libsafety_control_nodelet.so)
  mkdir "${library%/*}/ros"
  mv "$library" "${library%/*}/ros/"
}

# Debian's Python keeps what it compiled beside the sources, and who removes the package removes that.
maintainer_scripts() {
  rm -rf "$build/control"
  mkdir "$build/control"
  if [[ $prefix != /usr ]]; then return; fi  # py3compile knows no other folder
  script postinst "if [ \"\$1\" = configure ] && command -v py3compile >/dev/null; then py3compile -p $name; fi"
  script prerm "if command -v py3clean >/dev/null; then py3clean -p $name; fi"
}

script() {
  printf '#!/bin/sh\nset -e\n%s\n' "$2" >"$build/control/$1"
  chmod 755 "$build/control/$1"
}

# Such as 1.0.0-1~debian12: the next release's is newer, and an upgrade takes it.
version() { echo "$(in_package_xml version)-1~$(release | tr -d ' ')"; }

in_package_xml() {
  "$python" -c 'import sys; from xml.etree import ElementTree
print(" ".join(ElementTree.parse("package.xml").findtext(sys.argv[1]).split()))' "$1"
}

maintainer() {
  "$python" -c 'from xml.etree import ElementTree
one = ElementTree.parse("package.xml").find("maintainer")
print(one.text, "<" + one.get("email") + ">")'
}

compiled_files() {
  local file
  while IFS= read -rd '' file; do
    if [[ $(head -c 4 "$file" | tr -d '\0') == $'\x7fELF' ]]; then printf '%s\0' "$file"; fi
  done < <(find "$stage" -type f -print0)
}

# Its path is printed.
pack() {
  local compiled
  mapfile -d '' compiled < <(compiled_files)
  PACKED_DEPENDS=$(depends "${compiled[@]}")
  maintainer_scripts
  PACKED_FROM=$stage PACKED_NAME=$name PACKED_CONTROL=$build/control PACKED_VERSION=$(version) PACKED_MAINTAINER=$(maintainer)
  PACKED_DESCRIPTION=$(in_package_xml description)
  export "${!PACKED_@}"
  rm -rf "$build/packed"
  quietly "packing" cpack -G DEB --config scripts/package_parts/cpack.cmake -B "$build/packed"
  ls "$build"/packed/*.deb
}
