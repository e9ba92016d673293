#include <grader/sandbox/Sandbox.h>
// written by the sandbox helper
