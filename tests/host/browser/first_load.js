// SPDX-License-Identifier: Apache-2.0
// What has been loaded so far: bytes on the wire with their heads, bytes unpacked, addresses.
const all = [...performance.getEntriesByType('navigation'), ...performance.getEntriesByType('resource')];
return {
  wire: all.reduce((sum, each) => sum + each.transferSize, 0),
  whole: all.reduce((sum, each) => sum + each.decodedBodySize, 0),
  names: all.map(each => each.name),
};
