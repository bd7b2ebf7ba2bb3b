// MELSEC FX (FX3U): the instructions of the TP03, which took them from this family, with the devices of an FX3U. What the two do
// alike is defined by the TP03 manual, which "section" and F numbers refer to.

include "ladder.td"
include "melsec-fx/devices.td"
include "tp03/operands.td"
include "tp03/shapes.td"
include "tp03/instructions.td"
include "tp03/special.td"
include "tp03/errors.td"

def MelsecFx : Family<"melsec-fx", "MELSEC FX (FX3U; the instructions that it shares with the TP03)", "TP03"> {
  let header = "ladder/tp03.h";
  let ns = "tp03";
  let ops = "tp03";
  let base = "tp03";
  let models = ["FX3U"];
  let maxBranches = 8;
  let warnedBranches = 8;
  let maxLevels = 8;
  let maxLoops = 16;
  let maxCalls = 16;
  let maxMerge = 10;
  let warnedMerge = 9;
  let endLabel = 63;
  let hasIndexRegisters = 1;
  let errorsStop = 0;
  let firstScanPulses = 0;
  let clearsOnStop = 1;
  let spacedOperands = 1;
  let devices = [DevX, DevY, DevM, DevMS, DevS, DevT, DevC, DevCL, DevD, DevDS, DevR, DevV, DevZ, DevN, DevP, DevI];
}
