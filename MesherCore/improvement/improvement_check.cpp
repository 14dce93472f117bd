#include "improvement/improvement_check.h"
