export { CommandPalette } from './CommandPalette'
export {
  type Command,
  type Found,
  PaletteProvider,
  type SearchProvider,
  useCommands,
  useSearchProvider,
} from './registry'
