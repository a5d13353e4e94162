// The result "full" of a sequence must not be ignored.
#include "base/inplace_vector.h"

using namespace evc;

#ifdef MISTAKE
void f(InplaceVector<int, 4>& v) { v.push_back(1); }
#else
bool f(InplaceVector<int, 4>& v) { return v.push_back(1); }
#endif
