export {
  deliverySourcesQuery,
  type Sources,
  takeSourcesQuery,
  useStateDeliverySources,
  useStateTakeSources,
} from './api'
export { SourcesForm } from './SourcesForm'
export { SourcesText } from './SourcesText'
export { TakeSourcesPart } from './TakeSourcesPart'
