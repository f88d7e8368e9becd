// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/base.h: errors as values, progress and cancellation, arrays. Everything else in the face stands on it.
///
/// A function that can fail returns a Result: the value, or an Error with a text for people that says what went wrong,
/// where, and what to do. A function that returns no Result may throw std::bad_alloc, and nothing else; callbacks must
/// not throw. Long-running functions take a Progress and return within about a second of a request to cancel.
///
/// ~~~{.cpp}
/// /// Half of an even number.
/// tetra::Result<int> halfOf(int number)
/// {
///     if (number % 2 != 0)
///         return tetra::Error{tetra::ErrorKind::WrongUsage,
///                             tetra::Message::say("%1 is odd. Give an even number.", number)};
///     return number / 2;
/// }
///
/// /// Work of a hundred steps that tells how far it is and can be stopped from another thread.
/// tetra::Status countToHundred(std::stop_token stop, std::ostream& told)
/// {
///     const tetra::Progress progress(stop, [&](double fraction, const tetra::Message& activity) {
///         told << activity.text() << ' ' << int(100 * fraction) << " %\n";
///     });
///     for (int step = 1; step <= 100; ++step) {
///         if (progress.cancelled())
///             return tetra::cancelledError("Counting");
///         progress.report(step / 100.0, "Counting");
///     }
///     return {};
/// }
/// ~~~

#include <algorithm>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// Marks the public interface of the library.
#define TAN_API __attribute__((visibility("default")))
/// Marks what TAn's own programs and plugins call besides. Not for others: it changes without notice.
#define TAN_INTERNAL __attribute__((visibility("default")))

namespace tetra {

/// What kind of thing went wrong; the command line turns it into its exit code.
enum class ErrorKind {
    WrongUsage,    ///< the caller asked for something that does not exist or does not fit (exit 2)
    BadInput,      ///< a file or dataset that cannot be used as it is (exit 3)
    CannotWrite,   ///< a target that cannot be written, a full disk (exit 4)
    OutOfResource, ///< not enough memory, a limit of the format or of the machine (exit 4)
    Cancelled,     ///< the user stopped it (exit 130)
};

/// An English text that is shown later, as a label, a choice or an activity: Message::marked().
struct MarkedText {
    const char* text;

    constexpr operator std::string_view() const noexcept { return text; }
    operator std::string() const { return text; }
};

/// What is said to a user: an English sentence with places %1 to %9, and what stands in them. Programs that speak other
/// languages translate the sentence, and put the same into its places; which is why it is not put together from pieces.
class Message {
public:
    Message() = default;
    /// What is the same in every language: a name, a number, what another program said.
    Message(std::string text) : text_(std::move(text)) {}
    /// A text that is translated whole.
    Message(MarkedText marked) : text_(marked.text), sentence_(marked.text) {}
    Message(std::string_view text) : text_(text) {}
    Message(const char* text) : text_(text) {}
    template <std::integral Number> Message(Number number) : text_(std::to_string(number)) {}

    /// A sentence of this program, with its arguments: messages, or what is one. Translators' tools find it by this
    /// name, so it is a literal.
    template <class... Arguments> static Message say(const char* sentence, Arguments&&... arguments)
    {
        static_assert(sizeof...(arguments) <= 9);
        return of(sentence, {Message(std::forward<Arguments>(arguments))...});
    }
    /// Marks a text that is kept as it is until it is shown, for translators' tools, as say() does: a literal.
    static constexpr MarkedText marked(const char* text) noexcept { return {text}; }
    /// What say() makes, of a message that was taken apart.
    static Message of(std::string sentence, std::vector<Message> arguments)
    {
        Message message;
        message.sentence_ = std::move(sentence);
        message.arguments_ = std::move(arguments);
        message.text_ = message.filled();
        return message;
    }

    /// In English.
    const std::string& text() const noexcept { return text_; }
    /// With its places; empty if it is what every language has in common.
    const std::string& sentence() const noexcept { return sentence_; }
    const std::vector<Message>& arguments() const noexcept { return arguments_; }
    bool empty() const noexcept { return text_.empty(); }

    /// Whether they say the same.
    friend bool operator==(const Message& one, const Message& other) { return one.text_ == other.text_; }

private:
    std::string filled() const
    {
        std::string text;
        for (std::size_t i = 0; i < sentence_.size(); ++i) {
            const std::size_t place = sentence_[i] == '%' && i + 1 < sentence_.size()
                                          ? static_cast<std::size_t>(sentence_[i + 1] - '1')
                                          : arguments_.size();
            if (place < arguments_.size()) {
                text += arguments_[place].text_;
                ++i;
            } else {
                text += sentence_[i];
            }
        }
        return text;
    }

    std::string text_;
    std::string sentence_;
    std::vector<Message> arguments_;
};

/// An error is a value: what happened, where, and what to do about it.
struct Error {
    ErrorKind kind = ErrorKind::BadInput;
    Message message;

    /// In English.
    const std::string& text() const noexcept { return message.text(); }
};

/// Either a value or an Error. Never throws; `value()` on an error is a programming mistake: asserted, and undefined
/// without assertions.
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

/// The error that cancelled work returns.
inline Error cancelledError(const Message& activity)
{
    return {ErrorKind::Cancelled, Message::say("%1 was cancelled.", activity)};
}

/// Reports the progress of long-running work and carries requests to cancel it. Cheap to copy: pass by const reference,
/// copy into workers. Members may be called from any thread, so the callback must be thread-safe; it must not throw and
/// should return at once.
class Progress {
public:
    /// `fraction` in [0, 1], never decreasing within one piece of work; `activity` is a short text for the user.
    using Callback = std::function<void(double fraction, const Message& activity)>;

    /// Silent and not cancellable.
    Progress() = default;
    Progress(std::stop_token stop, Callback callback) : stop_(std::move(stop)), callback_(std::move(callback)) {}

    /// Long-running functions ask at least once a second.
    bool cancelled() const noexcept
    {
        if (stop_.stop_requested())
            return true;
        for (const OtherStop* other = others_.get(); other != nullptr; other = other->next.get())
            if (other->stop.stop_requested())
                return true;
        return false;
    }

    /// `activity` is what a Message is made of; it is made only if somebody listens.
    template <class Activity = Message> void report(double fraction, const Activity& activity) const
    {
        if (callback_)
            callback_(first_ + fraction * (last_ - first_), Message(activity));
    }

    /// The same progress for a step that covers [first, last] of the whole.
    Progress part(double first, double last) const
    {
        Progress result = *this;
        result.first_ = first_ + first * (last_ - first_);
        result.last_ = first_ + last * (last_ - first_);
        return result;
    }

    /// Cancelled by the same requests, but reporting its own [0, 1] to `callback`: for concurrent subtasks whose
    /// fractions the callback combines.
    Progress withCallback(Callback callback) const
    {
        Progress result(stop_, std::move(callback));
        result.others_ = others_;
        return result;
    }

    /// The same progress, cancelled by another request as well.
    Progress alsoCancelledBy(std::stop_token other) const
    {
        Progress result = *this;
        result.others_ = std::make_shared<const OtherStop>(OtherStop{std::move(other), others_});
        return result;
    }

private:
    struct OtherStop {
        std::stop_token stop;
        std::shared_ptr<const OtherStop> next;
    };

    std::stop_token stop_;
    std::shared_ptr<const OtherStop> others_;
    Callback callback_;
    double first_ = 0;
    double last_ = 1;
};

/// An allocator that leaves new elements of trivial types uninitialised, so that a buffer of gigabytes that is about
/// to be overwritten is not first filled with zeros.
template <class T> class UninitializedAllocator : public std::allocator<T> {
public:
    template <class U> struct rebind {
        using other = UninitializedAllocator<U>;
    };
    template <class U, class... Arguments> void construct(U* where, Arguments&&... arguments)
    {
        if constexpr (sizeof...(Arguments) == 0 && std::is_trivially_destructible_v<U>)
            ::new (static_cast<void*>(where)) U;
        else
            ::new (static_cast<void*>(where)) U(std::forward<Arguments>(arguments)...);
    }
};

/// A std::vector whose resize() leaves new elements uninitialised.
template <class T> using Buffer = std::vector<T, UninitializedAllocator<T>>;

} // namespace tetra
