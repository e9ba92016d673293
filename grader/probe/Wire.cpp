#include <grader/probe/Question.h>
