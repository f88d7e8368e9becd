// SPDX-License-Identifier: GPL-3.0-or-later
// An OpenDX file is a row of words: each object begins with the word `object`, its name and its class, and ends where
// the next one begins. Numbers stand behind the words `data follows`; else the header says where.
#include "plugins/readers/lattice/text/dx_objects.h"

#include "plugins/readers/lattice/headers/header_text.h"

#include <algorithm>
#include <array>
#include <limits>

namespace tetra {

namespace {

struct DxWord {
    std::string_view text;
    bool isQuoted = false;

    bool is(std::string_view word) const { return !isQuoted && text == word; }
};

Error dxError(const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("it is not understood as an OpenDX file: %1. Write it again as one field with regular "
                         "positions.",
                         what)};
}

/// Or 2^64 - 1 if it is larger.
std::uint64_t dxProduct(std::uint64_t one, std::uint64_t other)
{
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    return other != 0 && one > most / other ? most : one * other;
}

bool isDxBlank(char letter)
{
    return letter == ' ' || (letter >= '\t' && letter <= '\r') || letter == ',';
}

/// The words of a text, in which '#' begins a comment.
class DxWords {
public:
    explicit DxWords(std::string_view text) : text_(text) {}

    std::optional<DxWord> next()
    {
        skipBlanks();
        if (at_ >= text_.size())
            return {};
        if (text_[at_] == '"') {
            const std::size_t end = std::min(text_.find('"', at_ + 1), text_.size());
            const DxWord word{text_.substr(at_ + 1, end - at_ - 1), true};
            at_ = std::min(end + 1, text_.size());
            return word;
        }
        const std::size_t begin = at_;
        while (at_ < text_.size() && !isDxBlank(text_[at_]) && text_[at_] != '"' && text_[at_] != '#')
            ++at_;
        return DxWord{text_.substr(begin, at_ - begin)};
    }
    /// Past the end of the line.
    void skipLine() { at_ = std::min(std::min(text_.find('\n', at_), text_.size() - 1) + 1, text_.size()); }
    /// Past numbers in text, to the next word that is none.
    void skipNumbers()
    {
        bool isBegin = true;
        for (; at_ < text_.size(); ++at_) {
            const char letter = text_[at_];
            const bool isLetter = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
            const bool isOfNumber = letter == 'n' || letter == 'N' || letter == 'i' || letter == 'I'; // nan, inf
            if (isBegin && ((isLetter && !isOfNumber) || letter == '#'))
                return;
            isBegin = isDxBlank(letter);
        }
    }
    /// Past so many bytes, if there are as many.
    bool skipBytes(std::uint64_t bytes)
    {
        if (bytes > text_.size() - at_)
            return false;
        at_ += bytes;
        return true;
    }
    std::size_t place() const { return at_; }

private:
    void skipBlanks()
    {
        while (at_ < text_.size() && (isDxBlank(text_[at_]) || text_[at_] == '#'))
            if (text_[at_] == '#')
                skipLine();
            else
                ++at_;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

/// How data stand where an array does not say it.
struct DxMode {
    bool isText = true;
    std::optional<std::endian> order{};

    /// Whether the word says how data stand.
    bool take(const DxWord& word)
    {
        if (word.is("msb") || word.is("lsb"))
            order = word.is("msb") ? std::endian::big : std::endian::little;
        else if (word.is("text") || word.is("ascii"))
            isText = true;
        else if (word.is("binary") || word.is("ieee"))
            isText = false;
        else
            return false;
        return true;
    }
};

/// The words of an object behind its name, one after the other.
class DxReading {
public:
    explicit DxReading(std::span<const DxWord> words) : words_(words) {}

    bool atEnd() const { return at_ >= words_.size(); }
    const DxWord& peek() const { return words_[at_]; }
    DxWord next() { return atEnd() ? DxWord{} : words_[at_++]; }
    /// Takes all numbers that follow.
    std::vector<double> numbers()
    {
        std::vector<double> all;
        while (!atEnd() && !peek().isQuoted) {
            const auto number = parseHeaderNumber(peek().text);
            if (!number)
                break;
            all.push_back(*number);
            ++at_;
        }
        return all;
    }
    std::vector<std::uint64_t> counts()
    {
        std::vector<std::uint64_t> all;
        while (!atEnd() && !peek().isQuoted) {
            const auto number = parseNumber<std::uint64_t>(peek().text);
            if (!number)
                break;
            all.push_back(*number);
            ++at_;
        }
        return all;
    }

private:
    std::span<const DxWord> words_;
    std::size_t at_ = 0;
};

DxGrid dxGrid(DxReading words)
{
    DxGrid grid;
    while (!words.atEnd()) {
        const DxWord word = words.next();
        if (word.is("counts"))
            grid.counts = words.counts();
        else if (word.is("origin"))
            grid.origin = words.numbers();
        else if (word.is("delta"))
            grid.steps.push_back(words.numbers());
    }
    return grid;
}

/// The number that the next word is.
Result<std::uint64_t> dxCount(DxReading& words, std::string_view what)
{
    const DxWord word = words.next();
    const auto number = parseNumber<std::uint64_t>(word.text);
    return number ? Result<std::uint64_t>(*number)
                  : dxError(Message::say("'%1' after '%2' is not a whole number", printable(word.text), what));
}

/// `data 12`, `data file name,12` or `data follows`.
Status takeDataPlace(DxReading& words, DxArray& array)
{
    array.hasData = true;
    if (!words.atEnd() && words.peek().is("follows")) {
        words.next();
        return {};
    }
    const bool isElsewhere = !words.atEnd() && words.peek().is("file");
    if (isElsewhere) {
        words.next();
        array.file = std::string(words.next().text);
        if (array.file.empty())
            return dxError(Message::say("no name follows 'data file'"));
    }
    const auto offset = words.counts();
    if (isElsewhere)
        array.firstByte = offset.empty() ? 0 : offset.front();
    else if (offset.empty())
        return dxError(Message::say("'%1' after 'data' is not a position", printable(words.next().text)));
    else
        array.offset = offset.front();
    return {};
}

Result<DxArray> dxArray(DxReading words, const DxMode& usual)
{
    DxArray array;
    DxMode mode = usual;
    std::uint64_t rank = 0;
    std::vector<std::uint64_t> shape;
    while (!words.atEnd()) {
        const DxWord word = words.next();
        if (mode.take(word))
            continue;
        if (word.is("type")) {
            array.type = lowerCase(words.next().text);
            if ((array.type == "unsigned" || array.type == "signed") && !words.atEnd())
                array.type += " " + lowerCase(words.next().text);
        } else if (word.is("category")) {
            array.isComplex = words.next().is("complex");
        } else if (word.is("rank") || word.is("items")) {
            const auto count = dxCount(words, word.text);
            if (!count)
                return count.error();
            (word.is("rank") ? rank : array.items) = *count;
        } else if (word.is("shape")) {
            shape = words.counts();
        } else if (word.is("data")) {
            if (const Status placed = takeDataPlace(words, array); !placed)
                return placed.error();
        }
    }
    if (rank != shape.size())
        return dxError(Message::say("an array has rank %1, and its shape %2 numbers", rank, shape.size()));
    for (const std::uint64_t size : shape)
        array.components = dxProduct(array.components, size);
    array.isText = mode.isText;
    array.order = mode.order;
    return array;
}

/// The name of the object that a component is: `component "data" value 3`.
DxField dxField(const DxWord& name, DxReading words)
{
    DxField field{name.isQuoted ? std::string(name.text) : std::string(), {}};
    while (!words.atEnd()) {
        if (!words.next().is("component"))
            continue;
        const std::string component(words.next().text);
        DxWord value = words.next();
        if (value.is("value"))
            value = words.next();
        field.components[component] = std::string(value.text);
    }
    return field;
}

/// Goes through the objects.
class DxParser {
public:
    explicit DxParser(std::string_view text) : words_(text) {}

    Result<DxObjects> parse()
    {
        auto word = words_.next();
        while (word && !word->is("end")) {
            if (word->is("object")) {
                word = nextObject();
            } else if (word->is("mode")) { // data mode msb ieee
                do
                    word = words_.next();
                while (word && mode_.take(*word));
            } else {
                word = words_.next();
            }
            if (!problem_)
                return problem_.error();
        }
        words_.skipLine();
        objects_.headerBytes = words_.place();
        return std::move(objects_);
    }

private:
    static constexpr std::size_t mostWords = 1'000'000, mostObjects = 100'000;

    /// Bytes of the file, which begin behind 0.
    struct Piece {
        std::uint64_t begin = 0;
        std::uint64_t end = 0;
    };

    /// Reads an object behind the word that begins it, and returns the word behind it.
    std::optional<DxWord> nextObject()
    {
        if (++count_ > mostObjects)
            problem_ = dxError(Message::say("it has more than %1 objects", mostObjects));
        const auto name = words_.next();
        std::vector<DxWord> body;
        Piece data;
        bool isArray = false;
        std::optional<DxWord> word = words_.next();
        for (; word && !word->is("object") && !word->is("end"); word = words_.next()) {
            if (word->is("mode") && !body.empty() && body.back().is("data")) { // which is no part of the object
                body.pop_back();
                break;
            }
            isArray = isArray || (word->is("array") && (body.empty() || body.back().is("class")));
            body.push_back(*word);
            if (body.size() > mostWords)
                problem_ = dxError(Message::say("an object has more than %1 words", mostWords));
            const bool isData = isArray && data.begin == 0 && word->is("follows") && body.size() > 1 &&
                                body[body.size() - 2].is("data");
            if (isData)
                data = skipData(body);
            if (!problem_)
                return {};
        }
        if (name)
            add(*name, body, data);
        return word;
    }
    Piece skipData(const std::vector<DxWord>& body)
    {
        const auto array = dxArray(DxReading(body), mode_);
        if (array && !array->isText)
            words_.skipLine();
        const std::uint64_t begin = words_.place();
        if (!array)
            problem_ = array.error();
        else if (array->isText)
            words_.skipNumbers();
        else if (const auto type = dxNumberType(array->type);
                 type && !words_.skipBytes(dxProduct(dxProduct(array->components, storedSize(*type)), array->items)))
            problem_ = Error{ErrorKind::BadInput,
                             Message::say("an array of it should have %1 items, and the file ends before. It is cut "
                                          "short, or the number is wrong.",
                                          array->items)};
        return {begin, words_.place()};
    }
    void add(const DxWord& name, std::vector<DxWord>& body, const Piece& data)
    {
        if (!body.empty() && body.front().is("class"))
            body.erase(body.begin());
        const DxWord kind = body.empty() ? DxWord{} : body.front();
        const DxReading words(std::span<const DxWord>(body).subspan(body.empty() ? 0 : 1));
        const std::string key(name.text);
        if (kind.is("gridpositions")) {
            objects_.grids[key] = dxGrid(words);
        } else if (kind.is("field")) {
            objects_.fields.push_back(dxField(name, words));
        } else if (kind.is("array")) {
            addArray(key, dxArray(words, mode_), data);
        } else {
            objects_.otherClasses[key] = std::string(kind.text);
        }
    }

    void addArray(const std::string& key, Result<DxArray> array, const Piece& data)
    {
        if (!array) {
            problem_ = array.error();
            return;
        }
        if (data.begin != 0) {
            array->firstByte = data.begin;
            array->endByte = data.end;
        } else if (array->file.empty() && !array->offset) {
            array->hasData = false;
        }
        if (objects_.arrays.insert_or_assign(key, *std::move(array)).second)
            objects_.arrayOrder.push_back(key);
    }

    DxWords words_;
    DxMode mode_;
    DxObjects objects_;
    std::size_t count_ = 0;
    Status problem_;
};

} // namespace

std::optional<StoredType> dxNumberType(std::string_view type)
{
    struct Named {
        std::string_view name;
        StoredType type;
    };
    constexpr std::array<Named, 16> names{{{"double", StoredType::Float64},
                                           {"float", StoredType::Float32},
                                           {"int", StoredType::Int32},
                                           {"signed int", StoredType::Int32},
                                           {"uint", StoredType::UInt32},
                                           {"unsigned int", StoredType::UInt32},
                                           {"short", StoredType::Int16},
                                           {"signed short", StoredType::Int16},
                                           {"ushort", StoredType::UInt16},
                                           {"unsigned short", StoredType::UInt16},
                                           {"byte", StoredType::UInt8},
                                           {"ubyte", StoredType::UInt8},
                                           {"unsigned byte", StoredType::UInt8},
                                           {"char", StoredType::UInt8},
                                           {"unsigned char", StoredType::UInt8},
                                           {"signed byte", StoredType::Int8}}};
    const auto* const found = std::ranges::find(names, type, &Named::name);
    return found == names.end() ? std::nullopt : std::optional(found->type);
}

Result<DxObjects> parseDxObjects(std::string_view text)
{
    return DxParser(text).parse();
}

} // namespace tetra
