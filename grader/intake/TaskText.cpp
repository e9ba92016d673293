#include <grader/intake/TaskText.h>

#include <grader/base/Trimmed.h>
#include <grader/intake/SourcePiece.h>

#include <cctype>

namespace ticker::intake {
namespace {

bool isSpace(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool isClosedComment(std::string_view text) {
    return text.size() >= std::string_view{"/**/"}.size() && text.ends_with("*/");
}

}  // namespace

std::optional<std::string> taskText(std::string_view source, std::string_view task) {
    const std::string begin = "TASK " + std::string{task} + " begin";
    const std::string end = "TASK " + std::string{task} + " end";
    std::optional<std::string> text;
    for (std::size_t at = 0; at < source.size();) {
        const Piece piece = pieceAt(at, source);
        at += piece.text.size();
        if (piece.kind == Piece::Kind::comment) {
            const std::string_view comment = trimmed(piece.text.substr(2));
            if (comment == begin && !text) text.emplace();
            if (comment == end && text) return text;
        } else if (text && (piece.kind != Piece::Kind::character || !isSpace(piece.text.front()))) {
            *text += piece.text;
        }
    }
    return std::nullopt;
}

bool isStub(std::string_view source, std::string_view templateSource, std::string_view task) {
    const std::optional<std::string> text = taskText(source, task);
    return text && text == taskText(templateSource, task);
}

bool holdsCode(std::string_view source) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (source.starts_with(kByteOrderMark)) source.remove_prefix(kByteOrderMark.size());
    for (std::size_t at = 0; at < source.size();) {
        const Piece piece = pieceAt(at, source);
        at += piece.text.size();
        const bool isBlank = piece.kind == Piece::Kind::comment
                                 ? !piece.text.starts_with("/*") || isClosedComment(piece.text)
                                 : piece.text.size() == 1 && isSpace(piece.text.front());
        if (!isBlank) return true;
    }
    return false;
}

}  // namespace ticker::intake
