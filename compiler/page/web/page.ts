// SPDX-License-Identifier: MIT
// What a page of `directorc docs` does beyond its text. Without it, all of the text is there.

import { choosePicture } from './collapse';
import { readData } from './data';
import { byId } from './elements';
import { Finder } from './finder';
import { Matrix } from './matrix';
import { Pair } from './pair';

const data = readData();
const section = byId('picture');
const pictures = section ? choosePicture(section) : [];
new Finder(data, pictures);
new Pair(data);
new Matrix(data);
