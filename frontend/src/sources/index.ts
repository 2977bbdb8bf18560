export { deliverySourcesQuery, type Sources, useStateDeliverySources } from './api'
export { SourcesText } from './SourcesText'
export { TakeSourcesPart } from './TakeSourcesPart'
