// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/serve/http_server.h"
#include "core/serve/model_server.h"

#include "tests/waiting.h"

#include <QString>
#include <QTest>

#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tetra {

/// A server of this process.
class LocalServer {
public:
    /// Called with each request before it is answered, from the server's threads.
    using Before = std::function<void(const ServedRequest& request)>;

    /// `port`: 0 is any that is free.
    explicit LocalServer(
        const QString& folder, const std::string& token = {}, HttpLimits limits = {},
        ModelServerLimits modelLimits = {}, Before before = [](const ServedRequest&) {}, int atPort = 0,
        std::vector<std::string> origins = {})
        : models_(*ServedFolder::open(folder.toStdString()), {.token = token, .origins = std::move(origins)},
                  modelLimits),
          before_(std::move(before)), server_(limits,
                                              {.takesLong = ModelServer::takesLong,
                                               .answer =
                                                   [this](const ServedRequest& request) {
                                                       before_(request);
                                                       return models_.answer(request);
                                                   }},
                                              [this](const HttpRecord& record) {
                                                  const std::lock_guard lock(mutex_);
                                                  records_.push_back(record);
                                              })
    {
        const auto bound = server_.bind("127.0.0.1", atPort);
        port = bound ? *bound : 0;
        thread_ = std::jthread([this](const std::stop_token& stop) { (void)server_.run(Progress(stop, {})); });
    }

    std::vector<HttpRecord> records() const
    {
        const std::lock_guard lock(mutex_);
        return records_;
    }
    /// Waits for so many requests to be over.
    bool waitForRecords(std::size_t count) const
    {
        return waitFor([&] { return records().size() >= count; });
    }
    std::string address(const std::string& name) const
    {
        return "http://127.0.0.1:" + std::to_string(port) + "/" + name;
    }

    int port = 0;

private:
    ModelServer models_;
    Before before_;
    HttpServer server_;
    mutable std::mutex mutex_;
    std::vector<HttpRecord> records_;
    std::jthread thread_;
};

} // namespace tetra
