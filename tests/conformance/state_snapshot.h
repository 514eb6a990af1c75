// Every state that a query gives (tables 6.3-6.19), taken at one moment, to show that a rejected command
// changed none.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace conformance {

using StateSnapshot = std::map<std::string, std::vector<double>>;

StateSnapshot takeSnapshot();
// The names whose values differ, with both values; empty when the two are equal.
std::string difference(const StateSnapshot& before, const StateSnapshot& after);

}  // namespace conformance
