// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/loopback.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace tetra {

/// An HTTP server on the loopback that gives ranges of one file under every path, and does wrong what a test asks for.
class FaultyHttpServer {
public:
    struct Request {
        std::string path;
        std::optional<std::uint64_t> first, last; ///< of the header Range
        std::string ifRange;
        std::string authorization;
    };
    /// What is sent. A test changes what it likes.
    struct Reply {
        int status = 200;
        std::vector<std::pair<std::string, std::string>> headers; ///< Content-Length is added if it is not there
        std::string body;
        std::optional<std::string> raw;   ///< in place of all this
        std::optional<std::size_t> cutAt; ///< bytes of head and body, after which the connection is closed
        bool isLast = false;              ///< the connection is closed after it
        std::chrono::milliseconds before{0};
        std::chrono::milliseconds perByte{0}; ///< drips
        bool isSilent = false;                ///< sends nothing, ever

        void set(const std::string& name, const std::string& value)
        {
            const auto found = std::ranges::find(headers, name, &std::pair<std::string, std::string>::first);
            if (found == headers.end())
                headers.emplace_back(name, value);
            else
                found->second = value;
        }
        void remove(const std::string& name)
        {
            std::erase_if(headers, [&](const auto& header) { return header.first == name; });
        }
        void become(int newStatus, const std::string& newBody, const std::string& type)
        {
            status = newStatus;
            body = newBody;
            headers = {{"Content-Type", type}};
        }
    };
    /// Changes the reply to the request with this number, from 0; called from many threads.
    using Change = std::function<void(const Request& request, std::size_t number, Reply& reply)>;

    FaultyHttpServer(std::string content, Change change = {}) : content_(std::move(content)), change_(std::move(change))
    {
    }

    bool isUp() const { return listener_.isUp(); }
    std::uint16_t port() const { return listener_.port(); }
    std::string address(const std::string& path = "/model.tan", const std::string& scheme = "http://") const
    {
        return scheme + "127.0.0.1:" + std::to_string(port()) + path;
    }
    std::vector<Request> requests() const
    {
        const std::lock_guard lock(mutex_);
        return requests_;
    }
    void forget()
    {
        const std::lock_guard lock(mutex_);
        requests_.clear();
        mostAtOnce_ = 0;
    }
    int mostAtOnce() const { return mostAtOnce_; }
    /// The file is another one from now on.
    void replace(std::string content, std::string entityTag)
    {
        const std::lock_guard lock(mutex_);
        content_ = std::move(content);
        entityTag_ = std::move(entityTag);
    }

    static constexpr const char* date = "Wed, 01 Oct 2025 10:00:00 GMT";

private:
    void serve(int connection)
    {
        std::string waiting;
        for (;;) {
            std::size_t end = 0;
            while ((end = waiting.find("\r\n\r\n")) == std::string::npos) {
                pollfd ready{connection, POLLIN, 0};
                const int polled = ::poll(&ready, 1, 20);
                if (listener_.isStopped())
                    return;
                if (polled <= 0)
                    continue;
                char bytes[4096];
                const ssize_t got = ::recv(connection, bytes, sizeof bytes, 0);
                if (got <= 0)
                    return;
                waiting.append(bytes, static_cast<std::size_t>(got));
                if (waiting[0] == '\x16') { // TLS, which is not spoken here
                    Reply refusal;
                    refusal.raw = "HTTP/1.1 400 Bad Request\r\n\r\n";
                    send(connection, refusal);
                    return;
                }
            }
            const Request request = parsed(std::string_view(waiting).substr(0, end));
            waiting.erase(0, end + 4);
            if (!answer(connection, request))
                return;
        }
    }

    static Request parsed(std::string_view head)
    {
        Request request;
        const std::size_t path = head.find(' ') + 1;
        request.path = head.substr(path, head.find(' ', path) - path);
        while (!head.empty()) {
            const std::size_t end = std::min(head.find("\r\n"), head.size());
            const std::string_view line = head.substr(0, end);
            head.remove_prefix(std::min(end + 2, head.size()));
            const std::string_view range = "Range: bytes=", ifRange = "If-Range: ", authorization = "Authorization: ";
            if (line.starts_with(range)) {
                const std::string text(line.substr(range.size()));
                request.first = std::stoull(text);
                request.last = std::stoull(text.substr(text.find('-') + 1));
            } else if (line.starts_with(ifRange)) {
                request.ifRange = line.substr(ifRange.size());
            } else if (line.starts_with(authorization)) {
                request.authorization = line.substr(authorization.size());
            }
        }
        return request;
    }

    Reply honest(const Request& request) const
    {
        Reply reply;
        reply.headers = {{"ETag", entityTag_}, {"Last-Modified", date}, {"Accept-Ranges", "bytes"}};
        const bool isSame = request.ifRange.empty() || request.ifRange == entityTag_ || request.ifRange == date;
        if (!request.first || !isSame) {
            reply.body = content_;
            return reply;
        }
        const std::string total = std::to_string(content_.size());
        if (*request.first >= content_.size()) {
            reply.status = 416;
            reply.set("Content-Range", "bytes */" + total);
            return reply;
        }
        const std::uint64_t last = std::min<std::uint64_t>(*request.last, content_.size() - 1);
        reply.status = 206;
        reply.set("Content-Range",
                  "bytes " + std::to_string(*request.first) + '-' + std::to_string(last) + '/' + total);
        reply.body = content_.substr(*request.first, last - *request.first + 1);
        return reply;
    }

    /// Whether the connection stays open.
    bool answer(int connection, const Request& request)
    {
        Reply reply;
        std::size_t number = 0;
        {
            const std::lock_guard lock(mutex_);
            number = requests_.size();
            requests_.push_back(request);
            mostAtOnce_ = std::max(mostAtOnce_.load(), ++atOnce_);
            reply = honest(request);
        }
        if (change_)
            change_(request, number, reply);
        const bool isOpen = send(connection, reply);
        --atOnce_;
        return isOpen;
    }

    bool send(int connection, const Reply& reply)
    {
        if (!wait(reply.before))
            return false;
        while (reply.isSilent && !listener_.isStopped()) {
            pollfd gone{connection, POLLRDHUP, 0};
            if (::poll(&gone, 1, 20) > 0)
                return false;
        }
        std::string bytes;
        if (reply.raw) {
            bytes = *reply.raw;
        } else {
            bytes = "HTTP/1.1 " + std::to_string(reply.status) + " Whatever\r\n";
            bool hasLength = false;
            for (const auto& [name, value] : reply.headers) {
                bytes += name + ": " + value + "\r\n";
                hasLength = hasLength || name == "Content-Length";
            }
            if (!hasLength)
                bytes += "Content-Length: " + std::to_string(reply.body.size()) + "\r\n";
            bytes += "\r\n" + reply.body;
        }
        const bool isCut = reply.cutAt && *reply.cutAt < bytes.size();
        if (isCut)
            bytes.resize(*reply.cutAt);
        for (std::size_t sent = 0; sent < bytes.size();) {
            const std::size_t part = reply.perByte.count() > 0 ? 1 : bytes.size() - sent;
            const ssize_t went = ::send(connection, bytes.data() + sent, part, MSG_NOSIGNAL);
            if (went <= 0 || !wait(reply.perByte))
                return false;
            sent += static_cast<std::size_t>(went);
        }
        return !isCut && !reply.raw && !reply.isLast;
    }

    bool wait(std::chrono::milliseconds time) const
    {
        const auto end = std::chrono::steady_clock::now() + time;
        while (std::chrono::steady_clock::now() < end && !listener_.isStopped())
            std::this_thread::sleep_for(std::min(time, std::chrono::milliseconds(10)));
        return !listener_.isStopped();
    }

    mutable std::mutex mutex_;
    std::string content_;
    std::string entityTag_ = "\"first\"";
    Change change_;
    std::vector<Request> requests_;
    std::atomic<int> atOnce_ = 0, mostAtOnce_ = 0;
    LoopbackListener listener_{[this](int connection) { serve(connection); }};
};

} // namespace tetra
