// What most files of the engine include, precompiled with STICTION_SANITIZE.
#pragma once
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <variant>
#include <vector>
