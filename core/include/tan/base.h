// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/base.h: errors as values, progress and cancellation, arrays, numbers as text, files. Everything else in the face
/// stands on it.
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
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// Marks the public interface of the library.
#define TAN_API __attribute__((visibility("default")))
/// Marks what TAn's own programs call besides. Not for others: it changes without notice.
#define TAN_INTERNAL __attribute__((visibility("default")))

namespace tetra {

/// What kind of thing went wrong; the command line turns it into its exit code.
enum class ErrorKind {
    WrongUsage,    ///< the caller asked for something that does not exist or does not fit (exit 2)
    BadInput,      ///< a file or dataset that cannot be used as it is (exit 3)
    CannotWrite,   ///< a target that cannot be written, a full disk (exit 4)
    OutOfResource, ///< not enough memory, a limit of the format or of the machine (exit 4)
    Cancelled,     ///< the user stopped it (exit 130)
    NotYet,        ///< it waits for what others are still to make, such as the parts of a build (exit 5)
};

/// An English text that is shown later, as a label, a choice or an activity: Message::marked().
struct MarkedText {
    const char* text;

    constexpr operator std::string_view() const noexcept { return text; }
    operator std::string() const { return text; }
};

/// A whole number, as a text shows it: neither a truth value nor a character, which would be shown as one.
template <class Type>
concept WholeNumber =
    std::integral<Type> && !std::same_as<Type, bool> && !std::same_as<Type, char> && !std::same_as<Type, wchar_t> &&
    !std::same_as<Type, char8_t> && !std::same_as<Type, char16_t> && !std::same_as<Type, char32_t>;

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
    template <WholeNumber Number> Message(Number number) : text_(std::to_string(number)) {}

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

/// What a server wants of whoever asks before it gives anything.
enum class Credential { None, Password, Token };

/// An error is a value: what happened, where, and what to do about it. What programs ask about it stands in fields of
/// its own: nobody looks for it in the words.
struct Error {
    ErrorKind kind = ErrorKind::BadInput;
    Message message;
    /// The file or address that the message names. Empty: whoever knows which one it is adds its name.
    std::filesystem::path file{};
    /// What the server of that address wants, and was not given or not rightly.
    Credential wants = Credential::None;

    /// In English.
    const std::string& text() const noexcept { return message.text(); }
};

/// Either a value or an Error. Never throws; `value()` on an error is a programming mistake: asserted, and undefined
/// without assertions. A Result is true when it has a value; one of a bool is asked by ok(), as it would read like
/// that.
template <class Value> class [[nodiscard]] Result {
public:
    Result(Value value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

    bool ok() const noexcept { return content_.index() == 0; }
    explicit operator bool() const noexcept requires(!std::same_as<Value, bool>) { return ok(); }

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

// Numbers in files and options, the same under every locale: a decimal point, no grouping.

/// All of `text` as a Number: decimal, one leading '+' allowed. Nothing if anything else stands in it (blanks too) or
/// the number does not fit. Floating-point types know exponents, "inf" and "nan".
template <class Number>
requires std::integral<Number> || std::floating_point<Number> std::optional<Number> parseNumber(std::string_view text)
{
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size())
        return {};
    return number;
}

/// The shortest text that parseNumber() turns into the same number again.
TAN_API std::string formatNumber(double number);
TAN_API std::string formatNumber(float number);

/// What a piece of work needs of memory or of a disk, for messages: "12 MB", "1.3 GB", rounded up.
inline std::string neededBytesText(std::uint64_t bytes)
{
    const auto size = static_cast<double>(bytes);
    return bytes < 1'000'000'000 ? formatNumber(std::ceil(size / 1e6)) + " MB"
                                 : formatNumber(std::ceil(size / 1e8) / 10) + " GB";
}

/// A piece of somebody's file or option for a message: at most 80 bytes and no half character; what controls a
/// terminal, and what is no UTF-8, is replaced by '?'.
TAN_API std::string printable(std::string_view text);

/// A text of somebody else (a file or its name, a server, a plugin) for people: what would not be seen as itself stands
/// there as an escape, so that it neither commands a terminal nor passes for another line or another order of letters.
/// Control characters become "\n" or "\x1b", other line breaks, marks of direction and invisible characters "\u202e",
/// bytes that are no UTF-8 "\xff". All else stays, backslashes too; so twice is the same as once. Linear.
TAN_API std::string visibleText(std::string text);

/// A message with visibleText() wherever it is not a sentence of this program.
inline std::string visibleText(const Message& message)
{
    if (message.sentence().empty())
        return visibleText(message.text());
    std::vector<Message> arguments;
    for (const Message& argument : message.arguments())
        arguments.emplace_back(visibleText(argument));
    return Message::of(message.sentence(), std::move(arguments)).text();
}

/// The name's ending with its dot, in small letters.
inline std::string fileEnding(const std::filesystem::path& path)
{
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

/// A file mapped read-only. Its pages come into memory when they are read and leave it when memory is short, so a file
/// may be larger than the machine. Safe to read from any number of threads.
///
/// A file that another program cuts short, or a disk that fails, while it is mapped must not end this program: reads
/// then give zeros and damaged() becomes true. For that the first open() installs a handler for SIGBUS, the one
/// process-wide thing in core. Signals that do not come from a mapping of this class go on to the handler that was
/// there before; a program with a handler of its own installs it first.
class TAN_API MappedFile {
public:
    /// Errors: a file that is missing, no regular file or not readable; too many mapped files (1024).
    static Result<std::shared_ptr<const MappedFile>> open(const std::filesystem::path& path);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    const std::filesystem::path& path() const noexcept { return path_; }
    std::span<const std::byte> bytes() const noexcept { return bytes_; }

    /// True once the file was found cut short, unreadable or written to since it was opened: what was read may be
    /// wrong. One system call; ask after reading, not while.
    bool damaged() const noexcept;

private:
    MappedFile() = default;

    std::filesystem::path path_;
    std::span<const std::byte> bytes_;
    int descriptor_ = -1;
    std::int64_t modified_ = 0; ///< nanoseconds
    int guard_ = -1;            ///< index in the table that the signal handler reads
};

/// The paths of all that is in a folder, "" being the current one, in no order; `problem` says why some are missing.
/// May throw std::bad_alloc.
TAN_API std::vector<std::filesystem::path> pathsIn(const std::filesystem::path& folder, std::error_code& problem);

/// What a number of errno means, without a full stop: "No such file or directory". English under every locale, as all
/// messages: the C library's own texts follow the locale, and would stand in the middle of an English sentence.
TAN_API Message systemErrorText(int error);

/// Whether a number of errno says that this process or machine has no more memory, descriptors, threads or processes:
/// then it says nothing of the file, and another file or folder would not help.
TAN_API bool isLackOfResources(int error) noexcept;

/// What to do about a lack of resources, a sentence.
inline constexpr MarkedText resourceRemedy = Message::marked("Close other programs, or raise the limit (ulimit).");

/// The machine's physical memory in bytes, in use or not; 0 if the system does not tell.
TAN_API std::uint64_t physicalBytes() noexcept;
/// The most memory that this process can use: the machine's, or less if its address space is limited (ulimit -v); 0 if
/// the system does not tell.
TAN_API std::uint64_t usableBytes() noexcept;

} // namespace tetra
