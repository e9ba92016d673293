#include <grader/similar/PlainLines.h>

#include <grader/intake/SourcePiece.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace ticker::similar {
namespace {

using intake::Piece;

/// A source without its line splices, and with x for what is only part of names: as the compiler
/// reads it.
struct Spliced {
    std::string text;
    std::vector<std::size_t> from;  ///< where each character was, and the end
};

bool isAscii(char c) {
    return static_cast<unsigned char>(c) < 0x80;
}

// A backslash splices although spaces follow it: both compilers only warn of them.
Spliced withoutSplices(std::string_view source) {
    constexpr std::string_view kSpaces{" \t\r\f\v\0", 6};
    Spliced spliced;
    for (std::size_t at = 0; at < source.size(); ++at) {
        if (source[at] == '\\') {
            const std::size_t next = source.find_first_not_of(kSpaces, at + 1);
            if (next != std::string_view::npos && source[next] == '\n') {
                at = next;
                continue;
            }
        }
        spliced.text += isAscii(source[at]) && source[at] != '$' ? source[at] : 'x';
        spliced.from.push_back(at);
    }
    spliced.from.push_back(source.size());
    return spliced;
}

/// Where a piece ends in the spliced text. A backslash inside a raw string splices nothing.
std::size_t endOf(const Piece& piece, std::size_t at, const Spliced& spliced,
                  std::string_view source) {
    if (piece.kind != Piece::Kind::rawString) return at + piece.text.size();
    const std::size_t begin = spliced.from[at];
    const std::size_t end = begin + intake::rawString(source.substr(begin)).size();
    return static_cast<std::size_t>(std::ranges::lower_bound(spliced.from, end) -
                                    spliced.from.begin());
}

bool isPlain(char c) {
    return c > ' ' && c <= '~';
}

/// What stands for a piece; empty for white space.
std::string plain(const Piece& piece) {
    std::string text{piece.text};
    switch (piece.kind) {
        case Piece::Kind::comment:
            return "";
        case Piece::Kind::literal:
            return text.front() == '"' ? "\"\"" : "'0'";
        case Piece::Kind::rawString:
            return "\"\"";
        case Piece::Kind::number:
            std::erase(text, '\'');
            return text;
        case Piece::Kind::character:
            break;
    }
    return isPlain(text.front()) ? text : "";
}

/// Whether a header's name follows, as after `__has_include(`: in it `/*` starts no comment. After
/// `#include` it does no harm: there is no header of such a name, so that the file does not
/// compile.
bool asksForHeader(std::string_view code) {
    const auto takeSpaces = [&] { code = code.substr(0, code.find_last_not_of(" \n") + 1); };
    takeSpaces();
    if (!code.ends_with('(')) return false;
    code.remove_suffix(1);
    takeSpaces();
    return code.ends_with("__has_include") || code.ends_with("__has_include_next");
}

/// The length of the header's name in angle brackets with which `rest` starts, or 0. `before`: what
/// comes before it, without comments.
std::size_t headerLength(std::string_view before, std::string_view rest) {
    if (!rest.starts_with('<') || !asksForHeader(before)) return 0;
    const std::size_t end = rest.find_first_of(">\n");
    return end != rest.npos && rest[end] == '>' ? end + 1 : 0;
}

std::string plainText(std::string_view source) {
    const Spliced spliced = withoutSplices(source);
    std::string text;
    std::size_t lineEnds = 0;  // that are not yet in the text
    for (std::size_t at = 0; at < spliced.text.size();) {
        const std::size_t header = headerLength(text, std::string_view{spliced.text}.substr(at));
        const Piece piece = intake::pieceAt(at, spliced.text);
        const std::size_t end = header > 0 ? at + header : endOf(piece, at, spliced, source);
        const std::string_view whole =
            source.substr(spliced.from[at], spliced.from[end] - spliced.from[at]);
        lineEnds += static_cast<std::size_t>(std::ranges::count(whole, '\n'));
        const std::string code = header > 0 ? "<>" : plain(piece);
        if (code.empty())
            text += lineEnds > 0 ? std::string(std::exchange(lineEnds, 0), '\n') : " ";
        text += code;
        at = end;
    }
    return text;
}

}  // namespace

std::vector<std::string> plainLines(std::string_view source) {
    std::vector<std::string> lines;
    std::istringstream stream{plainText(source)};
    for (std::string line; std::getline(stream, line);)
        lines.push_back(std::move(line));
    return lines;
}

}  // namespace ticker::similar
