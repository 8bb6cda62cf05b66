#include "CatalystDouble.h"

#include "catalyst_impl_vfm_double.h"

enum catalyst_status catalyst_initialize_vfm_double(const conduit_node* node)
{
  return ReceiveFromCatalyst("initialize", node);
}

enum catalyst_status catalyst_execute_vfm_double(const conduit_node* node)
{
  return ReceiveFromCatalyst("execute", node);
}

enum catalyst_status catalyst_finalize_vfm_double(const conduit_node* node)
{
  return ReceiveFromCatalyst("finalize", node);
}

enum catalyst_status catalyst_about_vfm_double(conduit_node* node)
{
  conduit_node_set_path_char8_str(node, "catalyst/implementation", "vfm_double");
  return catalyst_status_ok;
}

enum catalyst_status catalyst_results_vfm_double(conduit_node*)
{
  return catalyst_status_ok;
}
