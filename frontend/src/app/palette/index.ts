export {
  type Command,
  type Found,
  PaletteProvider,
  type SearchProvider,
  useCommands,
  useSearchProvider,
} from './registry'
