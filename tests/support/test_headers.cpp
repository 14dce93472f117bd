// Without a source a library would have no precompiled headers.
#include <gtest/gtest.h>
