#pragma once
#include <string>

#include "io/json.h"

// Members of a document that are a document or name one. Errors have the place of the name.
namespace evc::io {

/// A document that is there or that a file has.
struct Named {
  std::string file;  ///< empty: in place
  std::string text;
};
/// The document that a value is, or names: a file, relative to that of the place, or a name without a folder and
/// without ".json" for a shipped one (NAME.json in `folder` of the data). Throws ReadError.
Named read_named(const JsonPlace& place, const std::string& folder);

/// Replaces the name that a member of an object has by the document. `owner`: the object, for errors and the folder of
/// files; it may be `document`. A member that is absent, or neither a document nor a name, stays as it is: its reader
/// refuses it. Returns the name of the file; empty where none was read. Throws ReadError.
std::string put_named(Json& document, const std::string& member, const std::string& folder, const JsonPlace& owner);

}  // namespace evc::io
