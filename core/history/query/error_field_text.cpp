// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/value_scale.h"

#include <tan/query.h>

#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

namespace tetra {

namespace {

using Node = ErrorField::Node;

constexpr std::array<std::string_view, 4> operationNames = {"sum", "product", "min", "max"};

std::string_view nameOf(FieldOperation operation)
{
    return operationNames[static_cast<std::size_t>(operation)];
}

void writeNumbers(std::initializer_list<double> numbers, std::string& text)
{
    const char* separator = "";
    for (const double number : numbers) {
        text += separator + formatNumber(number);
        separator = ", ";
    }
}

void writeRegion(const Box& box, std::string& text)
{
    text += "box(";
    writeNumbers({box.least.x(), box.least.y(), box.least.z(), box.largest.x(), box.largest.y(), box.largest.z()},
                 text);
}

void writeRegion(const Sphere& sphere, std::string& text)
{
    text += sphere.radius == 0 ? "camera(" : "sphere(";
    writeNumbers({sphere.centre.x(), sphere.centre.y(), sphere.centre.z()}, text);
    if (sphere.radius != 0)
        text += ", " + formatNumber(sphere.radius);
}

void writeRegion(const HalfSpace& half, std::string& text)
{
    text += "halfspace(";
    writeNumbers({half.normal.x(), half.normal.y(), half.normal.z(), half.offset}, text);
}

void write(const SpaceRamp& ramp, std::string& text)
{
    std::visit([&text](const auto& body) { writeRegion(body, text); }, ramp.region);
    text += "; ";
    writeNumbers({ramp.inner, ramp.outer, ramp.falloff}, text);
    text += ')';
}

void write(const ValueRamp& ramp, std::string& text)
{
    text += "values(";
    const char* separator = "";
    for (const auto& [value, error] : ramp.knots) {
        text += separator + formatNumber(value) + ':' + formatNumber(error);
        separator = ", ";
    }
    text += ')';
}

void write(const ErrorField& field, std::string& text);

/// The operands, which are combined from the left.
void writeOperands(FieldOperation operation, const ErrorField& field, std::string& text)
{
    const auto* const pair = std::get_if<Node::Pair>(&field.root().content);
    if (pair == nullptr || pair->operation != operation)
        return write(field, text);
    writeOperands(operation, pair->first, text);
    text += ", ";
    write(pair->second, text);
}

void write(const ErrorField& field, std::string& text)
{
    const Node& node = field.root();
    if (const double* const number = std::get_if<double>(&node.content)) {
        text += formatNumber(*number);
    } else if (const SpaceRamp* const inSpace = std::get_if<SpaceRamp>(&node.content)) {
        write(*inSpace, text);
    } else if (const ValueRamp* const overValues = std::get_if<ValueRamp>(&node.content)) {
        write(*overValues, text);
    } else {
        const FieldOperation operation = std::get_if<Node::Pair>(&node.content)->operation;
        text += std::string(nameOf(operation)) + '(';
        writeOperands(operation, field, text);
        text += ')';
    }
}

} // namespace

std::string toText(const ErrorField& field)
{
    std::string text;
    write(field, text);
    return text;
}

namespace {

constexpr int deepestExpression = 100;
constexpr int mostFields = 1000;

using Combine = ErrorField (*)(const ErrorField&, const ErrorField&);

ErrorField added(const ErrorField& a, const ErrorField& b)
{
    return a + b;
}
ErrorField multiplied(const ErrorField& a, const ErrorField& b)
{
    return a * b;
}

ErrorField smallerField(const ErrorField& a, const ErrorField& b)
{
    return smallerOf(a, b);
}

ErrorField largerField(const ErrorField& a, const ErrorField& b)
{
    return largerOf(a, b);
}

bool isLetter(char c)
{
    return c >= 'a' && c <= 'z';
}
bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// By recursive descent. After the first error, which is kept, everything else fails: functions then return something.
class Parser {
public:
    Parser(std::string_view text, const PresentView& present) : text_(text), present_(present) {}

    Result<ErrorField> run()
    {
        const ErrorField found = field();
        skipBlanks();
        if (place_ < text_.size())
            fail(Message::say("the end of the text"));
        if (error_)
            return *std::move(error_);
        return found;
    }

private:
    using Numbers = std::vector<double>;
    using Knots = std::vector<std::array<double, 2>>;

    ErrorField field()
    {
        if (++depth_ > deepestExpression || ++fields_ > mostFields)
            fail(Message::say("fewer fields: at most %1, nested up to %2 levels deep", mostFields, deepestExpression));
        skipBlanks();
        const ErrorField found = error_ ? ErrorField() : startsName() ? call() : ErrorField(size());
        --depth_;
        return found;
    }

    bool startsName() const
    {
        return place_ < text_.size() && isLetter(text_[place_]) && !text_.substr(place_).starts_with("inf");
    }

    ErrorField call()
    {
        const std::size_t start = place_;
        while (place_ < text_.size() && isLetter(text_[place_]))
            ++place_;
        const std::string_view name = text_.substr(start, place_ - start);
        const std::optional<ErrorField> found = named(name);
        if (!found) {
            place_ = start;
            fail(Message::say("a number or one of %1",
                              "box, sphere, halfspace, camera, values, isovalues, opacity, sum, product, min, max"));
        }
        expect(')');
        return found.value_or(ErrorField());
    }

    std::optional<ErrorField> named(std::string_view name)
    {
        if (name == "box")
            return box();
        if (name == "sphere")
            return sphere();
        if (name == "halfspace")
            return halfSpace();
        if (name == "camera")
            return camera();
        if (name == "values")
            return values();
        if (name == "isovalues")
            return isovalues();
        if (name == "opacity")
            return opacity();
        if (name == "sum")
            return combined(added);
        if (name == "product")
            return combined(multiplied);
        if (name == "min")
            return combined(smallerField);
        if (name == "max")
            return combined(largerField);
        return {};
    }

    ErrorField box()
    {
        const Numbers n = coordinates(6);
        return ramp(Box{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}});
    }

    ErrorField sphere()
    {
        const Numbers n = coordinates(3);
        expect(',');
        const double radius = size();
        return ramp(Sphere{{n[0], n[1], n[2]}, radius});
    }

    ErrorField halfSpace()
    {
        const Numbers n = coordinates(4);
        if (n[0] == 0 && n[1] == 0 && n[2] == 0)
            fail(Message::say("a half-space whose first three numbers are not all 0"));
        return ramp(HalfSpace{{n[0], n[1], n[2]}, n[3]});
    }

    ErrorField camera()
    {
        if (takesPresent(present_.eye.has_value(), Message::marked("the camera's position")))
            return ramp(Sphere{*present_.eye, 0});
        const Numbers n = coordinates(3);
        return ramp(Sphere{{n[0], n[1], n[2]}, 0});
    }

    /// Whether the list before the semicolon is left out; then what comes next is that sign.
    bool takesPresent(bool isPresent, MarkedText missing)
    {
        const std::size_t start = place_;
        expect('(');
        skipBlanks();
        const bool isLeftOut = !error_ && place_ < text_.size() && text_[place_] == ';';
        if (isLeftOut && !isPresent)
            fail(missing);
        if (!isLeftOut && !error_)
            place_ = start;
        return isLeftOut && isPresent;
    }

    ErrorField ramp(const Region& region)
    {
        const auto [inner, outer] = twoErrors();
        const double falloff = next(',') ? size() : 0;
        return SpaceRamp{region, inner, outer, falloff};
    }

    ErrorField values()
    {
        expect('(');
        skipBlanks();
        if (place_ < text_.size() && text_[place_] == ')')
            return ValueRamp{};
        return ValueRamp{knots()};
    }

    ErrorField isovalues()
    {
        Numbers found = present_.isovalues;
        if (!takesPresent(!found.empty(), Message::marked("the isovalues"))) {
            found.clear();
            expect('(');
            do
                found.push_back(value());
            while (next(','));
        }
        const auto [inner, outer] = twoErrors();
        const double falloff = next(',') ? size() : 0;
        return ErrorField::nearValues(found, inner, outer, falloff);
    }

    ErrorField opacity()
    {
        Knots found = present_.opacity;
        if (!takesPresent(!found.empty(), Message::marked("the opacities"))) {
            expect('(');
            found = knots();
        }
        const auto [inner, outer] = twoErrors();
        return ErrorField::byOpacity(found, inner, outer);
    }

    ErrorField combined(Combine combine)
    {
        expect('(');
        ErrorField all = field();
        expect(',');
        do
            all = combine(all, field());
        while (next(','));
        return all;
    }

    Numbers coordinates(std::size_t count)
    {
        Numbers found;
        for (std::size_t i = 0; i < count; ++i) {
            expect(i == 0 ? '(' : ',');
            found.push_back(number());
        }
        return found;
    }

    std::pair<double, double> twoErrors()
    {
        expect(';');
        const double inner = size();
        expect(',');
        return {inner, size()};
    }

    Knots knots()
    {
        Knots found;
        do {
            const double at = value();
            expect(':');
            found.push_back({at, size()});
        } while (next(','));
        return found;
    }

    /// Of the data: as parseFieldValue(), a number or the logarithm of one.
    double value()
    {
        constexpr std::string_view logarithm = "log10";
        skipBlanks();
        if (!text_.substr(place_).starts_with(logarithm))
            return number();
        place_ += logarithm.size();
        expect('(');
        const std::size_t start = place_;
        const double found = number();
        if (!error_ && !(found > 0)) {
            place_ = start;
            fail(Message::say("a number above 0"));
        }
        expect(')');
        return error_ ? 0 : portableLogarithm(found);
    }

    /// Finite, of any sign.
    double number()
    {
        const std::size_t start = place_;
        const double found = anyNumber(Message::marked("a number"));
        if (std::isfinite(found))
            return found;
        place_ = start;
        fail(Message::say("a finite number"));
        return 0;
    }

    /// Not negative; infinity is allowed.
    double size()
    {
        const std::size_t start = place_;
        const double found = anyNumber(Message::marked("a number, or the name of a field"));
        if (found >= 0)
            return found;
        place_ = start;
        fail(Message::say("a number that is not negative"));
        return 0;
    }

    double anyNumber(MarkedText what)
    {
        skipBlanks();
        std::string_view rest = text_.substr(place_);
        if (rest.starts_with('+') && !rest.starts_with("+-"))
            rest.remove_prefix(1);
        double found = 0;
        const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), found);
        if (problem == std::errc::result_out_of_range)
            fail(Message::say("a number of fewer than 308 digits"));
        else if (problem != std::errc())
            fail(what);
        else
            place_ = static_cast<std::size_t>(end - text_.data());
        return error_ ? 0 : found;
    }

    /// Whether the sign comes next; then it is passed over.
    bool next(char sign)
    {
        skipBlanks();
        if (error_ || place_ == text_.size() || text_[place_] != sign)
            return false;
        ++place_;
        return true;
    }

    void expect(char sign)
    {
        if (!next(sign))
            fail(std::string("'") + sign + "'");
    }

    void skipBlanks()
    {
        while (place_ < text_.size() && isBlank(text_[place_]))
            ++place_;
    }

    void fail(const Message& expected)
    {
        if (error_)
            return;
        skipBlanks();
        error_ =
            Error{ErrorKind::WrongUsage,
                  place_ == text_.size()
                      ? Message::say("The error field cannot be read at character %1: expected %2, but the text ends.",
                                     place_ + 1, expected)
                      : Message::say("The error field cannot be read at character %1: expected %2, but found '%3'.",
                                     place_ + 1, expected, printable(rest()))};
    }

    /// A glance at what comes next, never half a character.
    std::string rest() const
    {
        constexpr std::size_t glance = 12;
        if (text_.size() - place_ <= glance)
            return std::string(text_.substr(place_));
        std::size_t end = place_ + glance;
        while (end > place_ && (static_cast<unsigned char>(text_[end]) & 0xc0u) == 0x80)
            --end;
        return std::string(text_.substr(place_, end - place_)) + "...";
    }

    std::string_view text_;
    const PresentView& present_;
    std::size_t place_ = 0;
    int depth_ = 0;
    int fields_ = 0;
    std::optional<Error> error_;
};

} // namespace

Result<ErrorField> parseErrorField(std::string_view text, const PresentView& present)
{
    return Parser(text, present).run();
}

} // namespace tetra
