#ifndef TICKER_CMAKE_EXITDOESNOTRETURN_H
#define TICKER_CMAKE_EXITDOESNOTRETURN_H

// Included by Clang before all else in grader/probe/main.cpp, which defines this function: Clang
// wants the attribute on the first declaration, and glibc's has another spelling of it.
extern "C" [[noreturn]] void _Exit(int status) noexcept;

#endif
