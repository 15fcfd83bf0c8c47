// SPDX-License-Identifier: BSD-3-Clause
// Numbers as people read them.
import type { MaybeNumber } from "./protocol/messages";

/** Like C's %.{digits}g, without zeros at the end. */
export function general(value: MaybeNumber | undefined, digits: number): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const is_small = value !== 0 && Math.abs(value) < 1e-4;
  const text = is_small ? value.toExponential(digits - 1) : value.toPrecision(digits);
  const [mantissa, exponent] = text.split("e");
  const short = mantissa!.includes(".") ? mantissa!.replace(/\.?0+$/, "") : mantissa!;
  return exponent === undefined ? short : `${short}e${Number(exponent)}`;
}

export function scientific(value: MaybeNumber, digits: number): string {
  if (value === null) return "∞";
  return value === 0 ? "0" : value.toExponential(digits).replace("e+", "e");
}

export function count(value: number): string {
  return value.toLocaleString("en-US");
}

export function counted(value: number, one: string, many: string): string {
  return `${count(value)} ${value === 1 ? one : many}`;
}

/** A name as people write it: "Cost tolerance" for "cost-tolerance". */
export function label(name: string): string {
  const words = name.replaceAll("-", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}
