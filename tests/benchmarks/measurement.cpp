// SPDX-License-Identifier: BSD-3-Clause
#include "measurement.hpp"

#include <unistd.h>

#include <iostream>

#include "process_use.hpp"

namespace safety_control_cloud {
namespace {

template <typename ValueOf>
void print_list(const char* name, const std::vector<Answer>& answers, ValueOf value_of) {
  std::cout << '"' << name << "\": [";
  for (const auto& answer : answers) std::cout << (&answer == answers.data() ? "" : ", ") << value_of(answer);
  std::cout << "], ";
}

/// The lists hold a value for each cloud; the rest are means.
void print_report(const std::vector<Answer>& answers, const ProcessUse& before, const ProcessUse& after) {
  const auto clouds = static_cast<double>(answers.size());
  std::cout << '{';
  print_list("latency_ms", answers, [](const Answer& answer) { return 1e3 * answer.latency; });
  print_list("twists", answers, [](const Answer& answer) { return answer.twists; });
  print_list("speed", answers, [](const Answer& answer) { return answer.speed; });
  std::cout << "\"cpu_ms\": " << 1e3 * (after.cpu - before.cpu) / clouds
            << ", \"faults\": " << static_cast<double>(after.faults - before.faults) / clouds << '}' << std::endl;
}

Plan plan_of(const std::vector<std::string>& arguments) {
  Plan plan;
  plan.picture.width = std::stoul(arguments.at(0));
  plan.picture.height = std::stoul(arguments.at(1));
  plan.picture.point_step = 32;
  plan.picture.nan_share = 0.3;
  plan.picture.scene = "mixed";
  plan.rate = std::stod(arguments.at(2));
  plan.warm_up = std::stoi(arguments.at(3));
  plan.clouds = std::stoi(arguments.at(4));
  for (std::size_t i = 5; i < arguments.size(); ++i) plan.processes.push_back(std::stoi(arguments[i]));
  if (plan.processes.empty()) plan.processes = {getpid()};
  return plan;
}

}  // namespace

void measure(const Plan& plan, const ros::Publisher& clouds, const CloudSource& source) {
  Exchange exchange(clouds, plan.rate);
  exchange.meet();
  exchange.show(plan.warm_up, source);
  const ProcessUse before = use_of(plan.processes);
  const auto answers = exchange.show(plan.clouds, source);
  print_report(answers, before, use_of(plan.processes));
}

int run_camera(int argc, char** argv, const std::string& node, const std::function<void(const Plan&)>& run) {
  ros::init(argc, argv, node, ros::init_options::NoRosout);
  if (argc < 6) {
    std::cerr << "Usage: " << argv[0] << " WIDTH HEIGHT RATE WARM_UP CLOUDS [PID...]\n";
    return 2;
  }
  const ros::NodeHandle keeps_the_threads_running;
  run(plan_of({argv + 1, argv + argc}));
  return 0;
}

}  // namespace safety_control_cloud
