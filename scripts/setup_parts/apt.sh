# SPDX-License-Identifier: BSD-3-Clause
# Which machine this is, and what it lacks of apt's packages.

# Such as "debian 12".
release() {
  (if [[ -r /etc/os-release ]]; then . /etc/os-release; fi && echo "${ID:-unknown} ${VERSION_ID:-}")
}

# debian11, debian12, debian13; noetic, one (a ROS of Ubuntu's in /opt/ros); or "unknown ...".
machine() {
  local release
  release=$(release)
  if ! command -v apt-get >/dev/null; then echo "unknown $release"
  elif [[ -n $(distribution) ]]; then distribution
  else
    case $release in
      "debian 11" | "debian 12" | "debian 13") echo "${release// /}" ;;
      *) echo "unknown $release" ;;
    esac
  fi
}

# Those of the lists of that name there are; a platform may lack one.
packages_of() {
  local name
  for name in "$@"; do
    if [[ -v $name ]]; then
      local -n list=$name
      printf '%s\n' "${list[@]}"
    fi
  done
}

needed_packages() {
  local machine=$1 tests=
  if [[ $checks == yes ]]; then tests=check_; fi
  {
    packages_of common_packages ${tests:+common_check_packages}
    case $machine in
      noetic | one) packages_of ros_packages ${tests:+ros_check_packages} | sed "s/^/ros-$machine-/" ;;
      *) packages_of debian_packages ${tests:+debian_check_packages "${machine}_check_packages"} ;;
    esac
  } | sort -u
}

missing_packages() {
  comm -23 <(needed_packages "$1") \
    <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' 2>/dev/null | sed -n 's/^installed //p' | sort -u)
}

as_root() {
  if ((EUID == 0)); then "$@"
  elif [[ -t 2 ]]; then sudo "$@"
  else sudo -n "$@"; fi
}

# Those of the packages that apt could install.
known_to_apt() {
  LC_ALL=C apt-cache policy "$@" | awk '/^[^ ]/ { sub(":$", ""); name = $0 } /^  Candidate: / && $2 != "(none)" { print name }'
}

# Those of the packages that are optional, and that apt does not know.
unknown_options() {
  local package known
  known=$(known_to_apt "$@")
  for package in "$@"; do
    if [[ $optional_packages == *" $package "* ]] && ! grep -qxF "$package" <<<"$known"; then echo "$package"; fi
  done
}

installable() {
  if (($#)); then comm -23 <(printf '%s\n' "$@" | sort) <(unknown_options "$@" | sort); fi
}

# Which optional packages this release does not have, so that asking for them again needs no apt-get update.
absent=build/setup.absent

without_absent() {
  local package
  for package in "$@"; do
    if ! grep -qxF "$(release) $package" "$absent" 2>/dev/null; then echo "$package"; fi
  done
}

remember_absent() {
  unknown_options "$@" | sed "s/^/$(release) /" >>"$absent"
}

install_packages() {
  local machine missing
  machine=$(machine)
  if [[ $machine == unknown* ]]; then
    say "this machine (${machine#unknown }) is neither Debian 11, 12 or 13 nor one with apt and ROS in ${ros_folders[*]}."
    say "Needed are ROS 1 and what Debian 12 calls:"
    needed_packages debian12 | fmt -w 100 | sed 's/^/  /' >&2
    fail "install these, then run it with --no-packages"
  fi
  if [[ $machine != debian* && ! -e build/setup.done ]]; then
    say "its packages for ROS in /opt/ros/$machine have not been tried; where one is wrong, install what is meant and use --no-packages"
  fi
  mapfile -t missing < <(missing_packages "$machine")
  mapfile -t missing < <(without_absent "${missing[@]}")
  if ((${#missing[@]} == 0)); then return; fi
  if ((EUID != 0)) && { ! command -v sudo >/dev/null || { [[ ! -t 2 ]] && ! sudo -n true 2>/dev/null; }; }; then
    say "missing, and neither root nor sudo to install it with:"
    fail "apt-get install --no-install-recommends ${missing[*]}"
  fi
  quietly "apt-get update" as_root apt-get -o DPkg::Lock::Timeout=300 update
  remember_absent "${missing[@]}"
  mapfile -t missing < <(without_absent "${missing[@]}")
  if ((${#missing[@]} == 0)); then return; fi
  quietly "installing ${#missing[@]} apt packages" \
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install -y --no-install-recommends "${missing[@]}"
}

