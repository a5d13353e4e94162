#pragma once
#include <string>

#include "io/diagnostic.h"

namespace evc::language {

struct DescribeOptions {
  std::string id;         ///< NID_PACKET, NID_MESSAGE or the name of a variable; empty: a list
  bool markdown = false;  ///< as a page
  bool to_train = false, to_track = false;
  bool index = false;  ///< the index of the pages in docs/packets
};
/// `evc describe packets|variables|messages|schema`: the tables of the ETCS language (SUBSET-026-7, -8) on standard
/// output. Exit status: 0, or 2 when the packet, message or variable does not exist.
int describe_packets(const DescribeOptions& options);
int describe_variables(const DescribeOptions& options);
int describe_messages(const DescribeOptions& options);
int describe_schema();

/// The same texts. The error is that of the command.
io::Result<std::string> packets_text(const DescribeOptions& options);
io::Result<std::string> variables_text(const DescribeOptions& options);
io::Result<std::string> messages_text(const DescribeOptions& options);

}  // namespace evc::language
