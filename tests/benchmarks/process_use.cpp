// SPDX-License-Identifier: BSD-3-Clause
#include "process_use.hpp"

#include <time.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace safety_control_cloud {
namespace {

double cpu_of(pid_t process) {
  clockid_t clock;
  timespec used;
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &used) != 0) {
    throw std::runtime_error("no process " + std::to_string(process));
  }
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

/// minflt, the 8th value after the command in parentheses; see proc(5).
long faults_of(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string line, value;
  std::getline(file, line);
  const auto end_of_command = line.rfind(')');
  if (end_of_command == std::string::npos) throw std::runtime_error("no process " + std::to_string(process));
  std::istringstream values(line.substr(end_of_command + 1));
  for (int i = 0; i < 8; ++i) values >> value;
  return std::stol(value);
}

}  // namespace

ProcessUse use_of(const std::vector<pid_t>& processes) {
  ProcessUse use;
  for (const pid_t process : processes) {
    use.cpu += cpu_of(process);
    use.faults += faults_of(process);
  }
  return use;
}

}  // namespace safety_control_cloud
