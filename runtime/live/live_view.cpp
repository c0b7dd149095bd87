// Header: runtime/live/live_view.hpp. Test: tests/runtime/live/live_view_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/live/live_view.hpp"

#include "runtime/live/access.hpp"
#include "runtime/live/listener.hpp"
#include "runtime/live/server.hpp"

#include <cerrno>
#include <fstream>
#include <new>
#include <optional>
#include <sstream>
#include <system_error>

namespace director {

namespace {

std::optional<std::string> text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file) return std::nullopt;
  const bool is_empty = file.peek() == std::ifstream::traits_type::eof(); // then << has nothing to write, and fails
  if (file.bad() || (!is_empty && !(text << file.rdbuf()))) return std::nullopt;
  return std::move(text).str();
}

/// The page; nothing, with an error, if it cannot be read.
std::optional<live::Page> page_of(const LiveView::Options& options, std::string& error) {
  std::optional<std::string> read;
  if (!options.page.empty()) {
    read = text_of(options.page);
    if (!read)
      error = "cannot read the page " + options.page + ": " + std::generic_category().message(errno) +
              "; `directorc docs` writes one";
    if (!read) return std::nullopt;
  }
  const std::string_view html = read ? std::string_view(*read) : options.html;
  if (html.empty() && !read) return std::nullopt;
  std::optional<live::Page> page = live::to_send(html);
  if (!page)
    error = (read ? options.page : std::string("the page")) +
            " is not one that `directorc docs` wrote, in HTML: it has no policy of its own";
  return page;
}

/// The name under which other computers reach a server on all addresses.
std::string name_of(std::string authority, const std::vector<std::string>& own_names) {
  for (const std::string_view any : {"0.0.0.0", "[::]"}) {
    if (authority.starts_with(any) && !own_names.empty()) return own_names.front() + authority.substr(any.size());
  }
  return authority;
}

} // namespace

LiveView::LiveView(const Names& names) : LiveView(names, Options()) {}

LiveView::LiveView(const Names& names, const Options& options)
    : queue_(EventQueue::with_room_for(options.queue)),
      moments_(*names.tables) {
  if (queue_.size() < options.queue) {
    error_ = "there is no memory for " + std::to_string(options.queue) +
             " events that wait: give LiveView a smaller `queue`";
    return;
  }
  std::optional<live::Page> page = page_of(options, error_);
  const std::optional<std::string> token = live::new_token();
  if (!token) error_ = "the operating system has no random numbers for the token";
  if (!error_.empty()) return;
  live::Listener listener = live::listen_at(options.address, options.port);
  error_ = std::move(listener.error);
  if (!error_.empty()) return;
  std::vector<std::string> own_names = live::own_names();
  url_ = "http://" + name_of(std::move(listener.authority), own_names) + "/" + *token + "/";
  own_names.push_back(options.address);
  try {
    server_ = std::make_unique<live::Server>(
        listener.socket, std::make_unique<live::Feed>(queue_, moments_, names, options.memory),
        std::make_unique<live::Site>(names, std::move(page), *token, std::move(own_names)),
        live::Server::Options{
            .connections = options.connections, .interval = options.interval, .patience = options.patience});
  } catch (const std::system_error& problem) {
    error_ = "cannot start the thread that serves viewers: " + problem.code().message() +
             "; the limits of threads and memory of the program leave no place for it";
    url_.clear();
  }
}

LiveView::~LiveView() = default;

std::size_t LiveView::viewers() const { return server_ ? server_->viewers() : 0; }

void LiveView::allow(live::Commands commands) {
  if (server_) server_->allow(std::move(commands));
}

} // namespace director
