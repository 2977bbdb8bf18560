export { readFlacLayout } from './header'
export { flacSlices } from './samples'
