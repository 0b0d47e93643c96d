# SPDX-License-Identifier: BSD-3-Clause
# A Debian of its own in a folder, $root. Sourced by run; wants $platform, $cache (the platform's own folder) and $mirror.

declare -A suites=([debian11]=bullseye [debian12]=bookworm [debian13]=trixie)
passed_on=(http_proxy https_proxy no_proxy PIP_CERT PIP_INDEX_URL PIP_DEFAULT_TIMEOUT CMAKE_BUILD_PARALLEL_LEVEL)

# What reaches a mirror from the machine outside, a proxy or certificates of one's own, does so inside.
as_outside() {
  cp -L /etc/resolv.conf /etc/hosts "$1/etc/"
  if command -v apt-config >/dev/null; then
    apt-config dump | grep -E '^Acquire::(http|https|Check)' >"$1/etc/apt/apt.conf.d/99outside" || true
  fi
  if compgen -G '/usr/local/share/ca-certificates/*.crt' >/dev/null; then
    cp /usr/local/share/ca-certificates/*.crt "$1/usr/local/share/ca-certificates/"
    chroot "$1" update-ca-certificates
  fi
}

# Bare: debootstrap's minbase and the certificates. The packages' files stay in the cache, for the next one.
make_root() {
  local partial=$root.partial
  rm -rf --one-file-system "$partial"
  debootstrap --variant=minbase --include=ca-certificates --cache-dir="$cache/debs" "${suites[$platform]}" "$partial" "$mirror"
  as_outside "$partial"
  printf '#!/bin/sh\nexit 101\n' >"$partial/usr/sbin/policy-rc.d"  # no package starts a service
  chmod +x "$partial/usr/sbin/policy-rc.d"
  echo 'Binary::apt::APT::Keep-Downloaded-Packages "true";' >"$partial/etc/apt/apt.conf.d/98keep"
  echo force-unsafe-io >"$partial/etc/dpkg/dpkg.cfg.d/unsafe-io"  # who loses power makes it anew
  mv "$partial" "$root"
}

# inside FOLDER COMMAND [ARG...]: in the root, and in namespaces of its own: its mounts and processes end with it.
inside() {
  local environment=(HOME=/root LANG=C.UTF-8 "TERM=${TERM:-dumb}" PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
  local name
  for name in "${passed_on[@]}"; do
    if [[ -v $name ]]; then environment+=("$name=${!name}"); fi
  done
  unshare --mount --pid --fork --kill-child --propagation private bash -euc '
    root=$1 debs=$2
    shift 2
    mount -t proc proc "$root/proc"
    mount --rbind /sys "$root/sys"
    mount --rbind /dev "$root/dev"
    mount -t tmpfs tmpfs "$root/dev/shm"
    mount --bind "$debs" "$root/var/cache/apt/archives"
    exec chroot "$root" env -i "$@"' inside "$root" "$cache/debs" "${environment[@]}" bash -c 'cd "$0" && exec "$@"' "$@"
}

# The working tree as git sees it, with the files' times: what has not changed is not built again.
bring_sources() {
  local target=$root$1
  mkdir -p "$target"
  find "$target" -mindepth 1 -maxdepth 1 ! -name build ! -name devel ! -name .venv -exec rm -rf {} +
  git -c "safe.directory=$sources" -C "$sources" ls-files -z --cached --others --exclude-standard --deduplicate |
    (cd "$sources" && while IFS= read -rd '' file; do if [[ -e $file ]]; then printf '%s\0' "$file"; fi; done) |
    tar -C "$sources" --null --no-recursion --files-from=- -c | tar -C "$target" -x --no-same-owner
}
