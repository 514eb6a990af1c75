#pragma once

#include "layer/cache/database.h"

namespace anteroom::cache {

enum class SchemaState { Empty, Older, Current, Newer, Foreign, Error };

// What the file says it is. Error: ask the database.
SchemaState schemaState(Database& database);
// From Empty or Older, inside a transaction. An SQLite code.
int makeSchema(Database& database, SchemaState from);

}  // namespace anteroom::cache
