#include "base/standard_headers.h"
