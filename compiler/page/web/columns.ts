// SPDX-License-Identifier: MIT
// Arrays of numbers whose capacity grows by doubling: an object for each of millions of events would need too much memory.

type Numbers = Float64Array | Uint32Array;

export class Column<T extends Numbers> {
  length = 0;

  /** `at` may be read directly, up to `length`. */
  constructor(public at: T) {}

  push(value: number): void {
    if (this.length === this.at.length) this.reserve(Math.max(64, 2 * this.length));
    this.at[this.length++] = value;
  }

  /** Reserves capacity for `count` numbers, for callers that know how many they will add. */
  reserve(count: number): void {
    if (count <= this.at.length) return;
    const more = new (this.at.constructor as new (size: number) => T)(count);
    more.set(this.at.subarray(0, this.length));
    this.at = more;
  }

  get last(): number {
    return this.at[this.length - 1];
  }

  /** Removes the first `count` numbers. */
  drop(count: number): void {
    this.at.copyWithin(0, count, this.length);
    this.length -= count;
  }

  /** The number of values that are at most `value`, by binary search. They must be in ascending order. */
  upTo(value: number): number {
    let low = 0;
    let high = this.length;
    while (low < high) {
      const middle = (low + high) >>> 1;
      if (this.at[middle] <= value) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}

export const times = (): Column<Float64Array> => new Column(new Float64Array(0));
export const counts = (): Column<Uint32Array> => new Column(new Uint32Array(0));
