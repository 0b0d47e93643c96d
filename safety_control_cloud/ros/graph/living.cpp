// SPDX-License-Identifier: BSD-3-Clause
#include "living.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <ros/network.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <memory>

namespace safety_control_cloud {
namespace {

constexpr int patience = 500;  ///< [ms]

/// Closed with its scope.
class Socket {
 public:
  explicit Socket(const addrinfo& of) : number_(socket(of.ai_family, of.ai_socktype | SOCK_NONBLOCK, of.ai_protocol)) {}
  ~Socket() {
    if (number_ >= 0) close(number_);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  int number() const { return number_; }

 private:
  int number_;
};

bool refuses(const addrinfo& address) {
  const Socket socket(address);
  if (socket.number() < 0) return false;
  if (connect(socket.number(), address.ai_addr, address.ai_addrlen) == 0) return false;
  if (errno != EINPROGRESS) return errno == ECONNREFUSED;
  pollfd waiting{socket.number(), POLLOUT, 0};
  if (poll(&waiting, 1, patience) <= 0) return false;
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(socket.number(), SOL_SOCKET, SO_ERROR, &error, &size);
  return error == ECONNREFUSED;
}

}  // namespace

bool may_live(const std::string& address) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(address, host, port)) return true;
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_socktype = SOCK_STREAM;
  if (getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found) != 0) return true;
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> all(found, freeaddrinfo);
  for (const addrinfo* one = found; one; one = one->ai_next) {
    if (!refuses(*one)) return true;
  }
  return false;
}

}  // namespace safety_control_cloud
