# SPDX-License-Identifier: BSD-3-Clause
# The PyPI packages, in .venv/.

# numpy stays the system's: the compiled modules of ROS and matplotlib are built against that one.
install_python_packages() {
  local wanted kept=$root/.venv/installed group
  local -a packages=("${python_packages[@]}") alone=()
  for group in $(wanted_groups); do
    local -n of_group=${group}_packages
    packages+=("${of_group[@]}")
    if [[ $group == view ]]; then alone+=("${view_packages_alone[@]}"); fi
  done
  wanted=$(printf '%s\n' "$root" "$(readlink -f "$python")" "${packages[@]}" "${alone[@]}")
  if [[ -x $root/.venv/bin/python && $(cat "$kept" 2>/dev/null) == "$wanted" ]]; then return; fi
  quietly "making .venv" "$python" -m venv --clear --system-site-packages "$root/.venv"
  "$python" -c 'import numpy; print("numpy==" + numpy.__version__)' >"$root/.venv/constraints.txt" ||
    fail "$python has no numpy: install the system's (python3-numpy)"
  quietly "installing ${#packages[@]} PyPI packages" "$root/.venv/bin/python" -m pip install \
    --disable-pip-version-check --constraint "$root/.venv/constraints.txt" "${packages[@]}"
  if ((${#alone[@]})); then
    quietly "installing ${#alone[@]} more" "$root/.venv/bin/python" -m pip install \
      --disable-pip-version-check --no-deps "${alone[@]}"
  fi
  wanted_groups >"$root/.venv/groups"
  echo "$wanted" >"$kept"
}

# Those that are asked for now, those that were before, and those that tests need.
wanted_groups() {
  {
    cat "$root/.venv/groups" 2>/dev/null || true
    printf '%s\n' "${groups[@]}"
    if [[ $checks == yes ]]; then printf '%s\n' "${check_groups[@]}"; fi
  } | sed '/^$/d' | sort -u
}
