#ifndef TICKER_SESSION_CODEVIEW_H
#define TICKER_SESSION_CODEVIEW_H

#include <grader/result/SubmissionResult.h>

#include <string>
#include <vector>

namespace ticker::session {

/// A line of a student's file with a remark.
struct MarkedLine {
    std::string file;
    int line = 0;       ///< counted from 1
    std::string kind;   ///< its class in the style sheet: error, warning, proven
    std::string words;  ///< the remark, plain text; shown below the line
};

/// The lines that the compiler's errors and warnings point at, and those whose edit is proven to
/// mend a task.
[[nodiscard]] std::vector<MarkedLine> markedLines(const SubmissionResult& result);

/// The student's files as HTML. Each line has a button that opens a comment on it; marked lines are
/// coloured and followed by their remarks.
[[nodiscard]] std::string codeHtml(const std::vector<SourceText>& sources,
                                   const std::vector<MarkedLine>& marked);

}  // namespace ticker::session

#endif
