// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <httplib.h>

// <resolv.h>, which the library includes, makes a macro of a name that Eigen uses.
#undef _res
