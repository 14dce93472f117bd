#include "surface_sampling/curve_chains.h"
