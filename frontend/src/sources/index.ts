export { deliverySourcesQuery, type Sources, useStateDeliverySources } from './api'
export { SourcesForm } from './SourcesForm'
export { SourcesText } from './SourcesText'
export { TakeSourcesPart } from './TakeSourcesPart'
