// SPDX-License-Identifier: GPL-3.0-or-later
// What the manuals in the headers of the face show, taken out of their comments.
#include <header_examples.h>

#include <algorithm>
#include <ostream>

#include <base_example.h>
#include <build_example.h>
#include <data_example.h>
#include <fwd_example.h>
#include <mesh_example.h>
#include <model_example.h>
#include <open_example.h>
#include <packed_example.h>
#include <parameter_example.h>
#include <picture_example.h>
#include <query_example.h>
#include <render_example.h>
#include <tan_example.h>
#include <transfer_example.h>
#include <verify_example.h>
#include <version_example.h>
#include <view_example.h>
