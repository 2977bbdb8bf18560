export { VisionLine } from './VisionLine'
