// SPDX-License-Identifier: BSD-3-Clause
#include "last_word.hpp"

#include <ros/init.h>
#include <ros/xmlrpc_manager.h>
#include <semaphore.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "leaving.hpp"

namespace safety_control_cloud {
namespace {

using Say = const std::function<void()>;

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

sem_t asked;  ///< all that a signal handler may wake a thread with
std::atomic<bool> arrived[NSIG];
std::atomic<bool> shutdown_requested{false};
struct sigaction usual[NSIG];  ///< answers to them

/// Of the process, and for as long as it lives: its thread does not end.
struct Speakers {
  std::mutex mutex;
  std::set<Say*> all;
};

Speakers& speakers() {
  static Speakers* const speakers = new Speakers;
  return *speakers;
}

void on_signal(int number) {
  const int before = errno;
  arrived[number] = true;
  sem_post(&asked);
  errno = before;
}

void on_shutdown_request(XmlRpc::XmlRpcValue&, XmlRpc::XmlRpcValue& result) {
  shutdown_requested = true;
  sem_post(&asked);
  result = ros::xmlrpc::responseInt(1, "", 0);
}

/// As if it had not been held back.
void pass_on(int number) {
  const auto& answer = usual[number];
  if (answer.sa_handler == SIG_IGN) return;
  if (answer.sa_handler == SIG_DFL) {
    sigaction(number, &answer, nullptr);
    raise(number);
    return;
  }
  answer.sa_handler(number);
}

void speak() {
  const std::lock_guard<std::mutex> lock(speakers().mutex);
  if (speakers().all.empty()) return;
  for (Say* say : speakers().all) (*say)();
  let_it_leave();
}

[[noreturn]] void wait_for_requests() {
  for (;;) {
    if (sem_wait(&asked) != 0) continue;
    speak();
    for (const int number : signals) {
      if (arrived[number].exchange(false)) pass_on(number);
    }
    if (shutdown_requested.exchange(false)) ros::requestShutdown();
  }
}

void hold_requests_back() {
  sem_init(&asked, 0, 0);
  std::thread(wait_for_requests).detach();
  for (const int number : signals) {
    struct sigaction ours {};
    ours.sa_handler = on_signal;
    ours.sa_flags = SA_RESTART;
    sigaction(number, &ours, &usual[number]);
    const bool outlives_its_terminal = number == SIGHUP && usual[number].sa_handler == SIG_IGN;  // nohup
    if (outlives_its_terminal) sigaction(number, &usual[number], nullptr);
  }
  ros::XMLRPCManager::instance()->unbind("shutdown");
  ros::XMLRPCManager::instance()->bind("shutdown", on_shutdown_request);
}

}  // namespace

LastWord::LastWord(std::function<void()> say) : say_(std::move(say)) {
  static std::once_flag once;
  std::call_once(once, hold_requests_back);
  const std::lock_guard<std::mutex> lock(speakers().mutex);
  speakers().all.insert(&say_);
}

LastWord::~LastWord() {
  const std::lock_guard<std::mutex> lock(speakers().mutex);
  speakers().all.erase(&say_);
}

}  // namespace safety_control_cloud
