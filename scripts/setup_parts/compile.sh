# SPDX-License-Identifier: BSD-3-Clause
# Configuring and building, where something has changed.

# Asking make takes catkin over a second; the sources' times answer in a hundredth.
current() {
  [[ $(cat "$1" 2>/dev/null) == "$root" && -z $(find CMakeLists.txt package.xml setup.py msg srv tests/CMakeLists.txt \
    safety_control_cloud "${@:2}" -newer "$1" -type f ! -name '*.pyc' -print -quit) ]]
}

configure() {
  quietly "configuring $1/" cmake -S . -B "$1" -DPython3_EXECUTABLE="$python" \
    -DPython_EXECUTABLE="$python" -DPYTHON_EXECUTABLE="$python" "${@:2}"
}

compile() {
  quietly "building $2 in $1/" cmake --build "$1" --target "$2" --parallel "$(jobs_at_once)"
}

build() {
  local started=build/setup.started sanitized=safety_control_reading_tests
  if [[ -n ${SAFETY_CONTROL_SANITIZE-} ]]; then sanitized=safety_control_core_tests; fi
  if [[ $checks == no ]] && current build/setup.done; then return; fi
  if [[ $checks == yes && -z ${SAFETY_CONTROL_SANITIZE-} ]] && current build/checks.done tests; then return; fi
  echo "$root" >"$started"
  # ament, which pcl_ros reaches through pluginlib, takes the first Python of PATH.
  export PATH=/usr/bin:$PATH
  if [[ $checks == no ]]; then
    if [[ -e build/checks.done ]]; then configure build
    else configure build -DCMAKE_BUILD_TYPE=Release -DCATKIN_ENABLE_TESTING=OFF; fi
    compile build all
  else
    configure build -DCMAKE_BUILD_TYPE=Release -DCATKIN_ENABLE_TESTING=ON -DSAFETY_CONTROL_WERROR=ON
    compile build all
    compile build tests
    compile build safety_control_benchmarks
    configure build/sanitized -DCMAKE_BUILD_TYPE=None -DCATKIN_ENABLE_TESTING=ON -DCMAKE_CXX_FLAGS=-O1\ -g1 \
      -DSAFETY_CONTROL_SANITIZE=address,undefined
    compile build/sanitized "$sanitized"
    cp -p "$started" build/checks.done
  fi
  mv "$started" build/setup.done
}

# A build and a venv hold absolute paths: those of a clone that was moved are of no use.
forget_moved_build() {
  if [[ -e build/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" build/CMakeCache.txt; then
    find build -mindepth 1 -maxdepth 1 ! -name 'setup.*' -exec rm -rf {} +
    rm -rf devel
  fi
}

# PCL's templates take most of a gigabyte a compiler.
jobs_at_once() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/MemAvailable/ { print int($2 / 1000000) }' /proc/meminfo)
  echo $((memory < 1 ? 1 : memory < cores ? memory : cores))
}

