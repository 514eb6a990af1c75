#pragma once

namespace anteroom::inspect {

// The page of `report`; "<!--data-->" stands for its data, as JSON.
const char* reportPage();

}  // namespace anteroom::inspect
