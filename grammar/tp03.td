// TECO TP03 (types M, H, SR). Source: its user manual; "section" counts the sections of that manual, F numbers those of chapter 6.

include "ladder.td"
include "tp03/devices.td"
include "tp03/operands.td"
include "tp03/shapes.td"
include "tp03/instructions.td"
include "tp03/special.td"
include "tp03/errors.td"

def Tp03 : Family<"tp03", "TECO TP03", "TP03"> {
  let header = "ladder/tp03.h";
  let ns = "tp03";
  let ops = "tp03";
  let models = ["TP03H", "TP03M", "TP03SR"];
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
  let devices = [DevX, DevY, DevM, DevMS, DevS, DevT, DevC, DevCL, DevD, DevDS, DevV, DevZ, DevN, DevP, DevI];
}
