// MELSEC QS: the safety CPU QS001CPU. Source: its programming manual for common instructions; "section" counts that manual's
// sections.

include "ladder.td"
include "melsec-qs/devices.td"
include "melsec/operands.td"
include "melsec/shapes.td"
include "melsec-qs/contacts.td"
include "melsec-qs/outputs.td"
include "melsec-qs/compare.td"
include "melsec-qs/words.td"
include "melsec-qs/special.td"
include "melsec-qs/errors.td"

def MelsecQs : Family<"melsec-qs", "MELSEC QS (QS001CPU)", "QS"> {
  let header = "ladder/melsec_qs.h";
  let ns = "melsec_qs";
  let models = ["QS001CPU"];
  let maxBranches = 16;
  let maxLevels = 15;
  let pairsCrossClasses = 1;
  let devices = [DevX, DevY, DevM, DevB, DevF, DevSB, DevV, DevSM, DevT, DevST, DevC, DevD, DevW, DevSW, DevSD, DevN];
  let endNs = 8200000;
  let ioRefreshNs = 310000;
  let ioRefreshPointNs = 224;
  let notExecutedStepNs = 100;
}
