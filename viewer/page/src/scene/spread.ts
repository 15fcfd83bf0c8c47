// SPDX-License-Identifier: BSD-3-Clause
// An order of the numbers below a count, so that each beginning of it is a part that is spread evenly over all of them.

/** Returns 0, s, 2s, … modulo the count, with s near the golden section of it. */
export function spreadOrder(count: number): Uint32Array {
  let step = Math.max(1, Math.round(0.618034 * count));
  while (greatestCommonDivisor(step, count) > 1) ++step;
  const order = new Uint32Array(count);
  for (let i = 1; i < count; ++i) order[i] = (order[i - 1]! + step) % count;
  return order;
}

function greatestCommonDivisor(a: number, b: number): number {
  return b === 0 ? a : greatestCommonDivisor(b, a % b);
}
