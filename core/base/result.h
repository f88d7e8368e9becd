// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace tetra {

/// What kind of thing went wrong; the command line turns it into its exit code.
enum class ErrorKind {
    WrongUsage,    ///< the caller asked for something that does not exist or does not fit (exit 2)
    BadInput,      ///< a file or dataset that cannot be used as it is (exit 3)
    CannotWrite,   ///< a target that cannot be written, a full disk (exit 4)
    OutOfResource, ///< not enough memory, a limit of the format or of the machine (exit 4)
    Cancelled,     ///< the user stopped it (exit 130)
};

/// An error is a value. `text` is written for the user: what happened, where, and what to do about it.
struct Error {
    ErrorKind kind = ErrorKind::BadInput;
    std::string text;
};

/// Either a value or an Error. Never throws; `value()` on an error is a programming mistake (asserted).
template <class Value> class [[nodiscard]] Result {
public:
    Result(Value value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

    bool ok() const noexcept { return content_.index() == 0; }
    explicit operator bool() const noexcept { return ok(); }

    const Value& value() const& { return present(std::get_if<0>(&content_)); }
    Value& value() & { return present(std::get_if<0>(&content_)); }
    Value&& value() && { return std::move(present(std::get_if<0>(&content_))); }
    const Value* operator->() const { return &value(); }
    Value* operator->() { return &value(); }
    const Value& operator*() const& { return value(); }
    Value& operator*() & { return value(); }
    Value&& operator*() && { return std::move(*this).value(); }

    const Error& error() const { return present(std::get_if<1>(&content_)); }

private:
    template <class Type> static Type& present(Type* content)
    {
        assert(content != nullptr);
        return *content;
    }

    std::variant<Value, Error> content_;
};

/// A Result without a value: success, or an Error.
template <> class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : content_(std::move(error)) {}

    bool ok() const noexcept { return content_.index() == 0; }
    explicit operator bool() const noexcept { return ok(); }
    const Error& error() const
    {
        const Error* error = std::get_if<Error>(&content_);
        assert(error != nullptr);
        return *error;
    }

private:
    std::variant<std::monostate, Error> content_;
};

using Status = Result<void>;

/// The Error with which cancelled work ends.
inline Error cancelledError(std::string_view activity)
{
    return {ErrorKind::Cancelled, std::string(activity) + " was cancelled."};
}

} // namespace tetra
