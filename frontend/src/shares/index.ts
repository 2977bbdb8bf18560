export { Views } from './Views'
