# SPDX-License-Identifier: BSD-3-Clause
# What the package needs where it is installed. Sourced by scripts/package.

# The packages that package.xml has for run time, by its own names.
run_time_names() { sed -nE 's:.*<(depend|exec_depend)>(.*)</.*:\2:p' package.xml | sort -u; }

# As this machine calls them. Libraries are not among them: what was linked says which.
run_time_packages() {
  local machine=$1 name
  for name in $(run_time_names); do
    case $machine:$name in
      *:python3-*) echo "$name" ;;
      *:eigen | *:libpcl-all-dev) ;;  # headers, and libraries
      debian*)
        if [[ ! -v run_time_on_debian[$name] ]]; then
          fail "package.xml wants $name at run time: packages.sh does not say what Debian calls it"
        fi
        tr ' ' '\n' <<<"${run_time_on_debian[$name]}" | sed '/^$/d'
        ;;
      *) echo "ros-$machine-${name//_/-}" ;;
    esac
  done
}

# The packages of the libraries that the files are linked to, in their versions. A ROS in /opt tells no versions.
libraries_of() {
  local folder arguments=(-O --ignore-missing-info)
  folder=$(mktemp -d)
  mkdir "$folder/debian"
  printf 'Source: %s\n\nPackage: %s\nArchitecture: any\n' "$name" "$name" >"$folder/debian/control"
  if [[ $prefix != /usr ]]; then arguments+=("-l$prefix/lib"); fi
  (cd "$folder" && dpkg-shlibdeps "${arguments[@]}" "$@" 2>"$folder/said") >"$folder/found" || { cat "$folder/said" >&2; return 1; }
  sed -n 's/^shlibs:Depends=//p' "$folder/found" | sed 's/, /\n/g'
  rm -rf "$folder"
}

# A compiled module is one Python's.
python_range() {
  "$python" -c 'import sys; major, minor = sys.version_info[:2]
print(f"python3 (>= {major}.{minor})\npython3 (<< {major}.{minor + 1})")'
}

# All of them, as a control file has them.
depends() {
  local libraries packages
  libraries=$(libraries_of "$@")
  packages=$(run_time_packages "$machine")
  packages=$(only_known <<<"$packages")
  printf '%s\n' "$libraries" "$(python_range)" "$packages" | sort -u | paste -sd ',' | sed 's/,/, /g'
}

# Nobody could install what asks for a package that the release lacks: Ubuntu 20.04 has no python3-rich.
only_known() {
  local wanted known package
  mapfile -t wanted
  known=$(known_to_apt "${wanted[@]}")
  for package in "${wanted[@]}"; do
    if grep -qxF "$package" <<<"$known"; then echo "$package"; else say "apt does not know $package: not among what it depends on"; fi
  done
}
